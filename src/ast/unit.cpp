#include "ast/unused_nodes.hpp"

#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/unit.hpp>

#include <algorithm>
#include <memory>
#include <utility>

namespace iecfront {
namespace {

// Characters of a short string stand inside the object itself, and are counted with it.
[[nodiscard]] std::size_t heap_bytes(const std::string& text) noexcept {
    return text.capacity() > std::string().capacity() ? text.capacity() + 1 : 0;
}

[[nodiscard]] std::size_t heap_bytes(const Diagnostic& diagnostic) noexcept {
    std::size_t bytes = diagnostic.arguments.capacity() * sizeof(DiagnosticArgument) +
                        diagnostic.labels.capacity() * sizeof(DiagnosticLabel) +
                        diagnostic.fixes.capacity() * sizeof(DiagnosticFix);
    for (const DiagnosticArgument& argument : diagnostic.arguments)
        if (const auto* text = std::get_if<std::string>(&argument))
            bytes += heap_bytes(*text);
    for (const DiagnosticLabel& label : diagnostic.labels)
        bytes += heap_bytes(label.argument);
    for (const DiagnosticFix& fix : diagnostic.fixes) {
        bytes += fix.edits.capacity() * sizeof(TextEdit);
        for (const TextEdit& edit : fix.edits)
            bytes += heap_bytes(edit.replacement);
    }
    return bytes;
}

} // namespace

Unit::Unit(Parts parts) : parts_(std::move(parts)), line_end_count_(count_line_ends(parts_.text)) {}

Unit::~Unit() {
    delete lines_.load(std::memory_order_relaxed);
}

// Two threads may make it at the same time: the first one is kept.
const LineTable& Unit::lines() const noexcept {
    const LineTable* lines = lines_.load(std::memory_order_acquire);
    if (lines != nullptr)
        return *lines;
    auto made = std::make_unique<const LineTable>(parts_.text);
    if (lines_.compare_exchange_strong(lines, made.get(), std::memory_order_acq_rel))
        return *made.release();
    return *lines;
}

// Where nothing is reported, the parser has marked what it does not use.
ast::StoredNodes Unit::nodes() const {
    if (!parts_.diagnostics.empty() &&
        node_state_.load(std::memory_order_acquire) != NodeState::known)
        look_at_nodes();
    const std::span<const std::byte> memory = parts_.arena.bytes();
    return ast::StoredNodes(memory.subspan(ast::place_of(root(), memory)));
}

// By the first thread that comes; others wait for it.
void Unit::look_at_nodes() const {
    NodeState state = NodeState::unknown;
    if (node_state_.compare_exchange_strong(state, NodeState::looked_at,
                                            std::memory_order_acquire)) {
        ast::mark_all_unused_but(root(), parts_.arena.bytes());
        node_state_.store(NodeState::known, std::memory_order_release);
        node_state_.notify_all();
    }
    while (node_state_.load(std::memory_order_acquire) == NodeState::looked_at)
        node_state_.wait(NodeState::looked_at, std::memory_order_acquire);
}

TextRange Unit::range(const ast::Node& node) const noexcept {
    const std::span<const Token> tokens = parts_.tokens;
    if (node.first_token < node.end_token)
        return {tokens[node.first_token].offset(), tokens[node.end_token - 1].end()};
    std::uint32_t place = node.first_token == 0 ? 0 : tokens[node.first_token - 1].end();
    if (node.kind == ast::NodeKind::empty_statement) // its list may begin with its `;`
        place = tokens[node.first_token].offset();
    return {place, place};
}

std::size_t Unit::memory_bytes() const noexcept {
    std::size_t bytes =
        sizeof(Unit) + parts_.arena.capacity() + parts_.diagnostics.capacity() * sizeof(Diagnostic);
    if (lines_.load(std::memory_order_relaxed) != nullptr)
        bytes += sizeof(LineTable) + line_end_count_ * sizeof(std::uint32_t);
    for (const Diagnostic& diagnostic : parts_.diagnostics)
        bytes += heap_bytes(diagnostic);
    return bytes;
}

bool operator==(const Unit& a, const Unit& b) {
    return a.text() == b.text() && std::ranges::equal(a.tokens(), b.tokens()) &&
           std::ranges::equal(a.trivia(), b.trivia()) && ast::equal(a.root(), b.root()) &&
           std::ranges::equal(a.diagnostics(), b.diagnostics());
}

} // namespace iecfront
