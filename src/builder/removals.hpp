#pragma once

#include <iecfront/builder/changes.hpp>

#include <span>
#include <vector>

namespace iecfront::build {

/// Adds to `edits`, which put things in and are sorted, those that take `removals` out. How an
/// element goes depends on its siblings: which of them go as well, and which are `accompanied` by
/// something that was put in beside them.
void take_out(std::vector<TextEdit>& edits, std::span<const detail::Removal> removals,
              std::span<const ast::Node* const> accompanied);

} // namespace iecfront::build
