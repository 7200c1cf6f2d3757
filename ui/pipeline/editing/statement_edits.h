// Statements that are added, doubled, deleted, as edits that keep comments and layout.
#pragma once

#include <string>
#include <string_view>

#include "ui/pipeline/editing/statement_pieces.h"
#include "ui/pipeline/editing/text_edit.h"

namespace ui {

/// An edit, and where what it puts in stands afterwards.
struct StatementEdit {
    TextEdit edit;
    csg::scad::ByteRange added;  ///< Of the text after it; empty where nothing is put in.
};

/// A statement on a line of its own at the end of the text.
[[nodiscard]] StatementEdit append_statement(std::string_view text, std::string_view statement);

/// A copy on the line below. Of one that is `sole`, both in braces.
[[nodiscard]] StatementEdit double_statement(std::string_view text, const StatementText& statement);

/// Takes it away, with its line where nothing else is on that.
[[nodiscard]] StatementEdit delete_statement(std::string_view text, const StatementText& statement);

/// Something is subtracted from what the statement makes: within it, where that is a difference() already, else in a
/// difference() around both.
[[nodiscard]] StatementEdit subtract_from_statement(std::string_view text, const StatementText& statement,
                                                    std::string_view subtracted);

}  // namespace ui
