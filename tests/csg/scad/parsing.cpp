#include "tests/csg/scad/parsing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "csg/scad/text/ast_text.h"
#include "csg/scad/text/expression_text.h"

namespace test {

using namespace csg::scad;

SourceReader reader_of(Files files) {
    return [files = std::move(files)](const std::string& path) -> ReadResult {
        const auto found = files.find(path);
        if (found == files.end()) {
            return ReadError{true, "cannot read " + path + ": no such file"};
        }
        return found->second;
    };
}

namespace {

ParseRequest request(const std::string& text, const Files& files) {
    ParseRequest request;
    request.path = "main.scad";
    request.text = text;
    request.reader = reader_of(files);
    request.search_path = {"library"};
    return request;
}

}  // namespace

Parsed parse(const std::string& text, const Files& files, const std::vector<std::string>& definitions) {
    ParseRequest whole = request(text, files);
    whole.definitions = definitions;
    return csg::scad::parse(whole);
}

Parsed parse_lazily(const std::string& text, const Files& files) {
    ParseRequest lazy = request(text, files);
    lazy.lazy = true;
    return csg::scad::parse(lazy);
}

std::string messages(const Parsed& parsed) {
    std::string all;
    for (const Message& message : parsed.messages) {
        const std::string text = render(message, parsed.program.sources);
        all += text.substr(0, text.find('\n') + 1);
    }
    return all;
}

std::string tree(const std::string& text) {
    const Parsed parsed = parse(text);
    if (!parsed.ok) {
        return fmt::format("!{}", messages(parsed));
    }
    std::istringstream lines(without_comments(ast_text(parsed.program)));
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        line.erase(0, line.find_first_not_of('\t'));
        result += result.empty() ? "" : " ";
        result += line;
    }
    return result;
}

std::string without_comments(const std::string& tree) {
    std::istringstream lines(tree);
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("//")) {
            kept += line + '\n';
        }
    }
    return kept;
}

std::string value(const std::string& expression) {
    const Parsed parsed = parse("x = " + expression + ";");
    if (!parsed.ok) {
        return fmt::format("!{}", messages(parsed));
    }
    const auto assignments = parsed.program.assignments_of(parsed.program.blocks[parsed.program.units[0].block]);
    EXPECT_EQ(assignments.size(), 1U) << expression;
    return expression_text(parsed.program, assignments[0].value);
}

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace test
