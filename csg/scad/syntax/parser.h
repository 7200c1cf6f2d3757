// From source text to a Program: the grammar of OpenSCAD 2021.01 and newer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "csg/scad/source/diagnostics.h"
#include "csg/scad/source/source.h"
#include "csg/scad/syntax/ast.h"
#include "csg/scad/syntax/definitions.h"
#include "csg/scad/syntax/piece.h"

namespace csg::scad {

struct ParseRequest {
    std::string path;  ///< Of the main file; names it in messages, and includes are looked for beside it.
    std::string text;  ///< Of the main file.
    std::vector<std::string> definitions;  ///< `name=expression`, as of -D: assignments that come after the main file.
    SourceReader reader = read_source_file;
    SharedSource main{};                                          ///< In place of path and text, where given.
    std::function<SourceResult(const std::string& path)> find{};  ///< In place of the reader, where given.
    /// Of files that are parsed by themselves; null for others. May be empty.
    std::function<std::shared_ptr<const Piece>(const SharedSource& file)> piece_of{};
    std::vector<std::string> search_path = search_path_from_environment();
    bool lazy = false;  ///< Leaves bodies of definitions at top level unbuilt, if nothing is to be said about them.
    FileMaker make_missing{};  ///< Asked for an include or use that is found nowhere, beside the file that names it.
};

struct Parsed {
    Program program;
    std::vector<Message> messages;        ///< In the order in which they arose; they refer to program.sources.
    bool ok = false;                      ///< The main file parsed, with all that it includes: units[0].block is set.
    Definitions definitions;              ///< Those of the request; others may take their place.
    std::size_t main_messages = 0;        ///< So many of the messages are of the main file with what it includes, …
    std::size_t definition_messages = 0;  ///< … and so many after them of the definitions.
    std::size_t main_sources = 0;         ///< Of the sources those that had been read by then.
};

/// Thrown by parse() where pieces do not go together as they stand: what they include is to be parsed by tokens.
struct PieceMisfit {};

/// Parses the main file, what it includes, and what these use. Throws PieceMisfit at most. A syntax error ends the file
/// it is in and is one message that says what was expected; in an included file it ends the including file as well, in
/// a used one only that unit is without a block. A missing include or use is a warning, as in OpenSCAD.
[[nodiscard]] Parsed parse(const ParseRequest& request);

/// Sees to it that nothing moves when lazy bodies are built. `again`: some may have been, and what was added since was
/// not foreseen; it may happen again.
void make_room(Program& program, bool again = false);

/// Builds the body of a function or module (an index into Program::functions or ::modules) if that has been left out.
/// Adds nodes and symbols; what is there stays where it is.
void build_function_body(Program& program, std::uint32_t function);
void build_module_body(Program& program, std::uint32_t module);

}  // namespace csg::scad
