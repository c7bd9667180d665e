#include "format/broken_lines.hpp"
#include "format/unit_writer.hpp"

#include <iecfront/format/formatter.hpp>
#include <iecfront/parser/parse.hpp>

namespace iecfront {
namespace {

class Formatter {
public:
    Formatter(const SyntaxTree& tree, const FormatOptions& options)
        : tree_(tree), options_(options), line_end_(layout::line_end_of(tree)) {}

    std::string format() {
        std::string out;
        out.reserve(tree_.size() + tree_.size() / 8);
        for (const SyntaxTree::Slot& slot : tree_.slots())
            append(out, *slot.unit);
        if (!out.empty() && !out.ends_with(line_end_) && !ends_as_it_is_)
            out += line_end_;
        return out;
    }

private:
    void append(std::string& out, const Unit& unit) {
        const std::size_t begin = out.size();
        layout::write_unit(out, unit, line_end_, options_, nullptr);
        ends_as_it_is_ = out.size() == layout::leading_mark_size(unit);
        if (layout::broken_lines(unit).empty() ||
            is_stable(unit, std::string_view(out).substr(begin)))
            return;
        out.replace(begin, std::string::npos, unit.text());
        ends_as_it_is_ = true;
    }

    // What cannot be read is guessed by its layout as well: a layout that leads to other guesses is
    // none to give to a user.
    [[nodiscard]] bool is_stable(const Unit& unit, std::string_view written) const {
        if (!layout::reads_as(unit, written, tree_.options()))
            return false;
        const SyntaxTree again =
            parse(SourceText(std::string(written), {}, unit.encoding()), tree_.options());
        if (again.slots().size() != 1)
            return false;
        std::string twice(written.starts_with(line_end_) ? "-" : "");
        layout::write_unit(twice, *again.slots().front().unit, line_end_, options_, nullptr);
        return std::string_view(twice).substr(written.starts_with(line_end_) ? 1 : 0) == written;
    }

    const SyntaxTree& tree_;
    const FormatOptions& options_;
    std::string_view line_end_;
    bool ends_as_it_is_ = false;
};

} // namespace

std::string format(const SyntaxTree& tree, const FormatOptions& options) {
    return Formatter(tree, options).format();
}

} // namespace iecfront
