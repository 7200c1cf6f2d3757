// Statements that are added, doubled, deleted, as edits that keep comments and layout.
#pragma once

#include <optional>
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

/// Calls, such as "mirror([1, 0, 0]) ", are put before it.
[[nodiscard]] StatementEdit put_before_statement(const StatementText& statement, std::string_view calls);

/// It becomes the only child of `call` ("union()"), in braces.
[[nodiscard]] StatementEdit group_statement(std::string_view text, const StatementText& statement,
                                            std::string_view call);

/// The children of a statement that is `union() { … }` or a block of another boolean operation or hull() take its
/// place. Nothing where it is none, where it has no children, or where they could not stand there.
[[nodiscard]] std::optional<StatementEdit> ungroup_statement(std::string_view text, const StatementText& statement);

/// A union(), difference(), intersection(), hull() or minkowski() becomes another of these. Nothing of other calls.
[[nodiscard]] std::optional<StatementEdit> change_operation(std::string_view text, const StatementText& statement,
                                                            std::string_view name);

/// Puts `#`, `%`, `!` or `*` before it, or takes it away.
[[nodiscard]] StatementEdit toggle_modifier(std::string_view text, const StatementText& statement, char modifier);

/// A name that does not occur in the statement, for the variable of a loop around it.
[[nodiscard]] std::string loop_variable(std::string_view text, const StatementText& statement);

}  // namespace ui
