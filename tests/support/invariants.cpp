#include "support/invariants.hpp"

#include "support/edit_faults.hpp"
#include "support/tree_faults.hpp"

#include <gtest/gtest.h>
#include <string>

namespace iecfront::test {
namespace {

void expect_none(const std::string& fault, const SourceText& source) {
    EXPECT_EQ(fault, "") << fault << "\nin " << source.name() << ": " << quoted(source.bytes());
}

} // namespace

void expect_invariants(const SourceText& source, const ParseOptions& options) {
    const SyntaxTree tree = parse(source, options);
    expect_none(tree_fault(tree, source.bytes()), source);
    expect_none(output_fault(tree), source);
    EXPECT_TRUE(tree == parse(source, options)) << "reading twice differs: " << source.name();
    expect_none(edit_fault(source, options), source);
    expect_none(mutation_fault(source, options), source);
}

} // namespace iecfront::test
