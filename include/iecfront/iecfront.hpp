#pragma once

/// Everything iecfront offers. Start with `parse`.
#include <iecfront/ast/attached_comments.hpp>
#include <iecfront/ast/document_symbols.hpp>
#include <iecfront/ast/dump.hpp>
#include <iecfront/ast/editor_ranges.hpp>
#include <iecfront/ast/nodes.hpp>
#include <iecfront/ast/syntax_tree.hpp>
#include <iecfront/ast/token_classes.hpp>
#include <iecfront/ast/visitor.hpp>
#include <iecfront/compliance/annex_d.hpp>
#include <iecfront/compliance/annex_e.hpp>
#include <iecfront/compliance/dialects.hpp>
#include <iecfront/compliance/extensions.hpp>
#include <iecfront/compliance/features.hpp>
#include <iecfront/compliance/statement.hpp>
#include <iecfront/diagnostics/diagnostic.hpp>
#include <iecfront/diagnostics/render_json.hpp>
#include <iecfront/diagnostics/render_sarif.hpp>
#include <iecfront/diagnostics/render_text.hpp>
#include <iecfront/diagnostics/severity.hpp>
#include <iecfront/lexer/literals.hpp>
#include <iecfront/lexer/name.hpp>
#include <iecfront/lexer/standard_names.hpp>
#include <iecfront/lexer/token.hpp>
#include <iecfront/parser/parse.hpp>
#include <iecfront/source/source_text.hpp>
