// Parsing of texts in tests.
#pragma once

#include <map>
#include <string>

#include "csg/scad/syntax/parser.h"

namespace test {

using Files = std::map<std::string, std::string>;

/// A reader that knows these files, and none besides.
csg::scad::SourceReader reader_of(Files files);

/// Parses `text` as "main.scad" in a world where only `files` exist.
csg::scad::Parsed parse(const std::string& text, const Files& files = {},
                        const std::vector<std::string>& definitions = {});

/// The same, with the bodies of definitions left out where nothing is to be said about them.
csg::scad::Parsed parse_lazily(const std::string& text, const Files& files = {});

/// The syntax tree in one line, without what comments say: statements are separated by a blank. The messages, each
/// after a "!", where it does not parse.
std::string tree(const std::string& text);

/// The text of the only assignment's value: how "x = …;" is understood.
std::string value(const std::string& expression);

/// All messages: "main.scad:1:2: error: text", one a line.
std::string messages(const csg::scad::Parsed& parsed);

/// The lines of a syntax tree's text that are not comments.
std::string without_comments(const std::string& tree);

std::string read_file(const std::string& path);

}  // namespace test
