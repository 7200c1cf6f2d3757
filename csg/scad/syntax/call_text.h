// What stands where in the text of a call: for those who want to change what is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "csg/scad/syntax/ast.h"

namespace csg::scad {

/// A number with its sign, a string, `true`, `false` or `undef`, as written out.
struct LiteralText {
    ExprId expression = kNone;  ///< A literal, or the sign of a number.
    ByteRange bytes;            ///< Of the file's text (SourceFile::text), the quotes of a string included.
};

struct ArgumentText {
    std::string name;                   ///< Empty where none is written.
    ByteRange bytes;                    ///< With the name.
    ByteRange value;                    ///< Without it.
    std::vector<LiteralText> literals;  ///< Of the value, in the order of the text.
};

/// An instantiation of a module.
struct CallText {
    std::uint32_t file = 0;  ///< Index into Program::sources.
    std::string name;        ///< Of the module; `if` for one.
    ByteRange bytes;         ///< From the name to the closing parenthesis.
    std::vector<ArgumentText> arguments;
};

/// The call that begins at the place, which is as nodes of a Tree have it but for its `file`, an index into
/// Program::sources. Of a file that is included several times, the first one; nothing where none begins there, or it
/// does not lie in one file. Calls in bodies that have not been built are not found: no node is of them.
[[nodiscard]] std::optional<CallText> call_at(const Program& program, const SourceLocation& place);

/// Numbers that an edit of one place of the text changes together.
struct NumberSource {
    std::string variable;              ///< That they are assigned to at the top of the main file; empty: in the call.
    std::vector<LiteralText> numbers;  ///< In the order of the text.
};

/// What the arguments of the call at the place are made of, as far as it is numbers written out in the main file: those
/// of the call itself first, then those of each variable that it names, or that such a variable names.
[[nodiscard]] std::vector<NumberSource> numbers_behind(const Program& program, const SourceLocation& place);

/// The literal that the byte belongs to, or that ends before it; nothing where there is none. `file`:
/// an index into Program::sources.
[[nodiscard]] std::optional<LiteralText> literal_at(const Program& program, std::uint32_t file, std::size_t offset);

}  // namespace csg::scad
