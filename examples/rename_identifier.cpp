// Renames an identifier in one file and prints the new text. Names that differ in case only are the
// same name (2.1.2); comments, strings and everything else stay as they are, byte for byte.
#include "read_source.hpp"

namespace ast = iecfront::ast;

namespace {

// Collects the places of a name. Whether two things of that name are the same is a question of
// meaning, which is not asked here: all of them are renamed.
class Renamer : public ast::Visitor<Renamer> {
public:
    Renamer(std::string_view from, std::string_view to)
        : from_(from), to_(to), hash_(iecfront::hash_name(from)) {}

    void rename_in(const iecfront::SyntaxTree::Slot& slot) {
        slot_ = &slot;
        traverse(slot.unit->root());
    }

    ast::Walk visit(const ast::Identifier& name) { return rename(name, name.hash); }
    ast::Walk visit(const ast::VariableName& name) { return rename(name, name.hash); }
    ast::Walk visit(const ast::DerivedTypeName& name) { return rename(name, name.hash); }

    // `Type#Value` is one token with two names.
    ast::Walk visit(const ast::EnumeratedValue& node) {
        const iecfront::TextRange range = slot_->range(node);
        const auto [type, value] = iecfront::split_enumerated_value(slot_->unit->text(node));
        if (iecfront::names_equal(type, from_))
            add({range.begin, range.begin + static_cast<std::uint32_t>(type.size())});
        if (iecfront::names_equal(value, from_))
            add({range.end - static_cast<std::uint32_t>(value.size()), range.end});
        return ast::Walk::over;
    }

    // In source order, as the tree is walked.
    [[nodiscard]] const std::vector<iecfront::TextEdit>& edits() const { return edits_; }

private:
    // Most names differ in their hash, and their spelling need not be looked at.
    ast::Walk rename(const ast::Node& name, std::uint32_t hash) {
        if (hash == hash_ && iecfront::names_equal(slot_->unit->text(name), from_))
            add(slot_->range(name));
        return ast::Walk::over;
    }
    void add(iecfront::TextRange range) { edits_.push_back({range, to_}); }

    std::string from_;
    std::string to_;
    std::uint32_t hash_;
    const iecfront::SyntaxTree::Slot* slot_ = nullptr;
    std::vector<iecfront::TextEdit> edits_;
};

} // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs("usage: rename_identifier FILE OLD-NAME NEW-NAME\n", stderr);
        return 2;
    }
    const std::optional<iecfront::SourceText> source = read_source(argv[1]);
    if (!source)
        return 2;
    const iecfront::SyntaxTree tree = iecfront::parse(*source);
    Renamer renamer(argv[2], argv[3]);
    for (const iecfront::SyntaxTree::Slot& slot : tree.slots())
        renamer.rename_in(slot);
    std::fputs(iecfront::apply_edits(source->bytes(), renamer.edits()).c_str(), stdout);
    std::fprintf(stderr, "%zu places renamed\n", renamer.edits().size());
}
