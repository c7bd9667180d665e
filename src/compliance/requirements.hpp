#pragma once

#include <array>
#include <string_view>

namespace iecfront {

/// A requirement of 1.5.1 on a system that complies, and how it is met.
struct Requirement {
    char letter;
    std::string_view demand; ///< in our words
    bool met;                ///< else in part
    std::string_view how;
};

inline constexpr std::array requirements = {
    Requirement{'a', "no other elements needed to reach a feature of the standard", true,
                "settings are options of the library and the command; the text needs none"},
    Requirement{'b', "the values of all parameters of Annex D", true,
                "see Implementation-dependent parameters"},
    Requirement{'c', "determining violations, and telling when that is incomplete", false,
                "the form of texts is examined, their meaning is not; no text is therefore "
                "determined to have no violations, but at best that none were found and the "
                "examination is incomplete"},
    Requirement{'d', "treating each error of Annex E in one of four ways", false,
                "see Error conditions; those that are not yet examined are treated in none"},
    Requirement{'e', "a description of each extension", true, "see Extensions"},
    Requirement{'f', "processing the use of an extension like an error", true,
                "each is reported as an error, as a warning or not at all, as the user says"},
    Requirement{'g', "processing the use of an implementation-dependent feature like an error",
                false, "see Implementation-dependent parameters for what is reported"},
    Requirement{'h', "no standard names for what behaves differently", true,
                "no types, functions or function blocks are added to those of the standard"},
    Requirement{'i', "the formal syntax in the form of Annex A", true,
                "`docs/grammar.md`; tests compare it with the parser"},
    Requirement{'j', "reading and writing library elements in ISO/IEC 646", true,
                "`write` gives the text of any tree in it; characters beyond it become `$` "
                "combinations in strings, and are reported where they stand elsewhere"},
};

} // namespace iecfront
