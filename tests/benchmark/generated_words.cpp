#include "benchmark/generated_words.hpp"

namespace iecfront::bench {
namespace {

using namespace std::string_view_literals;

constexpr std::array devices = {
    "Pump"sv, "Valve"sv, "Tank"sv, "Motor"sv,  "Belt"sv, "Heater"sv, "Mixer"sv,    "Filter"sv,
    "Door"sv, "Cyl"sv,   "Axis"sv, "Boiler"sv, "Fan"sv,  "Silo"sv,   "Press"sv,    "Drill"sv,
    "Grip"sv, "Lift"sv,  "Feed"sv, "Compr"sv,  "Damp"sv, "Burner"sv, "Conveyor"sv, "Drv"sv,
};
constexpr std::array places = {
    "Main"sv, "Upper"sv, "Inlet"sv, "Out"sv, "Act"sv, "Last"sv, "Raw"sv, "Front"sv, "Aux"sv,
};
constexpr std::array properties = {
    "Speed"sv,     "Level"sv,  "Press"sv,  "Temp"sv, "Start"sv,    "Stop"sv,   "Ready"sv,
    "Fault"sv,     "Enable"sv, "Req"sv,    "Pos"sv,  "Setpoint"sv, "Lim"sv,    "Count"sv,
    "Delay"sv,     "Alarm"sv,  "Active"sv, "Run"sv,  "Open"sv,     "Closed"sv, "Mode"sv,
    "Err"sv,       "Output"sv, "Gain"sv,   "Flow"sv, "Torque"sv,   "Weight"sv, "Ack"sv,
    "Interlock"sv, "Cmd"sv,    "Fbk"sv,    "Old"sv,
};
constexpr std::array shorts = {
    "i"sv, "k"sv, "x"sv, "idx"sv, "cnt"sv, "tmp"sv, "val"sv, "ok"sv, "err"sv, "no"sv, "pos"sv,
};
constexpr std::array prefixes = {"b"sv, "x"sv, "r"sv, "n"sv, "i"sv, "w"sv};
constexpr std::array prose = {
    "the"sv,      "pump"sv,    "of"sv,      "a"sv,       "is"sv,       "valve"sv,   "only"sv,
    "started"sv,  "when"sv,    "tank"sv,    "level"sv,   "below"sv,    "limit"sv,   "and"sv,
    "operator"sv, "has"sv,     "to"sv,      "confirm"sv, "alarm"sv,    "see"sv,     "drawing"sv,
    "sheet"sv,    "12"sv,      "seconds"sv, "after"sv,   "release,"sv, "because"sv, "drive"sv,
    "needs"sv,    "time"sv,    "run"sv,     "down:"sv,   "bar,"sv,     "not"sv,     "changed"sv,
    "since"sv,    "version"sv, "2.1"sv,     "in"sv,      "m3/h"sv,     "slow"sv,    "hand"sv,
};

constexpr std::size_t longest_code = 70; // what is longer goes on in the next line

[[nodiscard]] std::string digits(std::size_t value) {
    return std::to_string(value);
}

} // namespace

std::string joined(std::initializer_list<std::string_view> pieces) {
    std::string text;
    for (const std::string_view piece : pieces)
        text += piece;
    return text;
}

std::string make_name(Random& random) {
    if (random.chance(12))
        return joined({random.pick(shorts), digits(random.below(10))});
    if (random.chance(40))
        return joined({random.pick(properties), digits(random.below(25))});
    const bool underscores = random.chance(25);
    std::string name;
    if (!underscores && random.chance(25))
        name += random.pick(prefixes);
    if (random.chance(12)) {
        name += random.pick(places);
        name += underscores ? "_" : "";
    }
    name += random.pick(devices);
    name += underscores ? "_" : "";
    name += random.pick(properties);
    return name;
}

std::string make_prose(Random& random, std::size_t words) {
    std::string text;
    for (std::size_t i = 0; i < words; ++i) {
        text += i == 0 ? "" : " ";
        text += random.pick(prose);
    }
    return text;
}

std::string make_integer(Random& random) {
    static constexpr std::array forms = {
        "16#FF"sv, "2#1010_0001"sv, "8#17"sv, "INT#7"sv, "UINT#16#3FFF"sv, "1_000_000"sv,
    };
    if (random.chance(10))
        return std::string(random.pick(forms));
    return digits(random.chance(60) ? random.below(10) : random.below(5000));
}

std::string make_real(Random& random) {
    std::string text = joined({digits(random.below(400)), ".", digits(random.below(100))});
    if (random.chance(10))
        text += "E-3";
    return random.chance(4) ? "REAL#" + text : text;
}

std::string make_duration(Random& random) {
    static constexpr std::array forms = {
        "T#1h30m"sv, "TIME#2.5s"sv, "T#5m_30s"sv, "t#1d12h"sv, "T#-20ms"sv,
    };
    if (random.chance(20))
        return std::string(random.pick(forms));
    const bool seconds = random.chance(50);
    return "T#" + digits(random.between(1, 900)) + (seconds ? "s" : "ms");
}

std::string make_string(Random& random) {
    std::string text = "'" + make_prose(random, random.between(1, 3));
    if (random.chance(20))
        text += "$N";
    return text + '\'';
}

// ---- lines --------------------------------------------------------------------------------------

void LineWriter::line(std::string_view code, std::size_t comment_percent) {
    text_.append(depth_ * 4, ' ');
    while (code.size() > longest_code && code.find('\'') == code.npos) {
        const std::size_t blank = code.rfind(' ', longest_code);
        if (blank == code.npos)
            break;
        text_ += code.substr(0, blank);
        end_line();
        text_.append(depth_ * 4 + 8, ' ');
        code.remove_prefix(blank + 1);
    }
    text_ += code;
    if (random_.chance(comment_percent))
        text_ += "  (* " + make_prose(random_, random_.between(1, 5)) + " *)";
    end_line();
}

void LineWriter::unindented_line(std::string_view code) {
    text_ += code;
    end_line();
}

void LineWriter::comment_line() {
    line("(* " + make_prose(random_, random_.between(4, 10)) + " *)");
}

void LineWriter::head_comment(std::string_view name) {
    line("(* " + std::string(name) + ": " + make_prose(random_, random_.between(3, 7)));
    for (std::size_t i = random_.between(1, 7); i > 0; --i)
        line("   " + make_prose(random_, random_.between(5, 11)));
    line("   " + make_prose(random_, random_.between(2, 8)) + " *)");
}

void LineWriter::end_line() {
    text_ += '\n';
    ++lines_;
}

} // namespace iecfront::bench
