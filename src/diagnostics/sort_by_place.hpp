#pragma once

#include <iecfront/diagnostics/diagnostic.hpp>

#include <algorithm>
#include <vector>

namespace iecfront {

/// Orders by where the ranges begin; what begins at one place stays in its order. Mostly there are
/// one or two rows that are ordered already: these take time in proportion to their length.
inline void sort_by_place(std::vector<Diagnostic>& diagnostics) {
    const auto before = [](const Diagnostic& a, const Diagnostic& b) {
        return a.range.begin < b.range.begin;
    };
    const auto begin = diagnostics.begin();
    const auto end = diagnostics.end();
    const auto second = std::is_sorted_until(begin, end, before);
    if (second == end)
        return;
    if (!std::is_sorted(second, end, before))
        std::stable_sort(second, end, before);
    std::inplace_merge(begin, second, end, before);
}

} // namespace iecfront
