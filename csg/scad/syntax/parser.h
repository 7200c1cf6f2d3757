// From source text to a Program: the grammar of OpenSCAD 2021.01 and newer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "csg/scad/source/diagnostics.h"
#include "csg/scad/source/source.h"
#include "csg/scad/syntax/ast.h"

namespace csg::scad {

/// The made-up name of the text that holds the definitions.
inline constexpr std::string_view kCommandLine = "<command line>";

struct ParseRequest {
    std::string path;  ///< Of the main file; names it in messages, and includes are looked for beside it.
    std::string text;  ///< Of the main file.
    std::vector<std::string> definitions;  ///< `name=expression`, as of -D: assignments that come after the main file.
    SourceReader reader = read_source_file;
    std::vector<std::string> search_path = search_path_from_environment();
    bool lazy = false;  ///< Leaves bodies of definitions at top level unbuilt, if nothing is to be said about them.
    FileMaker make_missing{};  ///< Asked for an include or use that is found nowhere, beside the file that names it.
};

struct Parsed {
    Program program;
    std::vector<Message> messages;  ///< In the order in which they arose; they refer to program.sources.
    bool ok = false;                ///< The main file parsed, with all that it includes: units[0].block is set.
};

/// Parses the main file, what it includes, and what these use. Never throws. A syntax error ends the file it is in
/// and is one message that says what was expected; in an included file it ends the including file as well, in a used
/// one only that unit is without a block. A missing include or use is a warning, as in OpenSCAD.
[[nodiscard]] Parsed parse(const ParseRequest& request);

/// Builds the body of a function or module (an index into Program::functions or ::modules) if that has been left out.
/// Adds nodes and symbols; what is there stays where it is.
void build_function_body(Program& program, std::uint32_t function);
void build_module_body(Program& program, std::uint32_t module);

}  // namespace csg::scad
