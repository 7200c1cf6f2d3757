// Where statements of a program's text begin and end, of one with errors too: no syntax tree is needed.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "csg/scad/source/source.h"

namespace ui {

/// The text cut behind every `;`, `{` and `}` that is none in parentheses, and behind the files of include and use;
/// what stands behind it on its line, if only comments do, goes with it. The pieces follow each other and are all of
/// the text.
[[nodiscard]] std::vector<csg::scad::ByteRange> statement_pieces(std::string_view text);

struct StatementText {
    /// From its first character to its semicolon or closing brace: with the calls before it (`translate(…) cube();` is
    /// one), its children, and an else.
    csg::scad::ByteRange bytes;
    bool sole = false;  ///< It is all of a definition's body or an else, without braces: others cannot stand beside it.
};

/// The innermost statement that the byte is in; nothing in comments and between statements.
[[nodiscard]] std::optional<StatementText> statement_at(std::string_view text, std::size_t offset);

}  // namespace ui
