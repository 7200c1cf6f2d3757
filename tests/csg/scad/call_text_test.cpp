// Which bytes of the text a call, its arguments and their literals are.
#include "csg/scad/syntax/call_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/csg/scad/evaluate_text.h"
#include "tests/csg/scad/parsing.h"

namespace {

using csg::scad::ByteRange;
using csg::scad::CallText;
using csg::scad::Program;
using csg::scad::SourceFile;

std::string cut(const Program& program, std::uint32_t file, const ByteRange& bytes) {
    return program.sources[file].text().substr(bytes.begin, bytes.end - bytes.begin);
}

/// "name(argument|value: literal literal, …)".
std::string shown(const Program& program, const std::optional<CallText>& call) {
    if (!call) {
        return "none";
    }
    std::string text = cut(program, call->file, call->bytes) + " =";
    for (const auto& argument : call->arguments) {
        text += fmt::format(" {{{}|{}:", cut(program, call->file, argument.bytes),
                            cut(program, call->file, argument.value));
        for (const auto& literal : argument.literals) {
            text += fmt::format(" {}", cut(program, call->file, literal.bytes));
        }
        text += "}";
    }
    return text;
}

TEST(CallText, ArgumentsAndTheirLiterals) {
    const auto call = [](const std::string& text) {
        const auto parsed = test::parse(text);
        return shown(parsed.program, call_at(parsed.program, parsed.program.instantiations[0].where.begin()));
    };
    EXPECT_EQ(call("cube([10, -2.5, a + 3e1], center = true);"),
              "cube([10, -2.5, a + 3e1], center = true) = {[10, -2.5, a + 3e1]|[10, -2.5, a + 3e1]: 10 -2.5 3e1} "
              "{center = true|true: true}");
    EXPECT_EQ(call("  translate ( v = f(1, x = \"\xC3\xA4\\\"\") ) ;"),
              "translate ( v = f(1, x = \"\xC3\xA4\\\"\") ) = {v = f(1, x = \"\xC3\xA4\\\"\")|f(1, x = "
              "\"\xC3\xA4\\\"\"): 1 \"\xC3\xA4\\\"\"}");
    EXPECT_EQ(call("m([for (i = 0, j = 1; i < 2; i = i + 3) let (k = 4) if (k) each [5:6:7] else -i],\n\r\n undef);"),
              "m([for (i = 0, j = 1; i < 2; i = i + 3) let (k = 4) if (k) each [5:6:7] else -i],\n\r\n undef) = "
              "{[for (i = 0, j = 1; i < 2; i = i + 3) let (k = 4) if (k) each [5:6:7] else -i]|[for (i = 0, j = 1; i < "
              "2; i = i + 3) let (k = 4) if (k) each [5:6:7] else -i]: 0 1 2 3 4 5 6 7} {undef|undef: undef}");
    EXPECT_EQ(call("if (a == 1) cube();"), "cube() =");
}

/// As an editor does: from a node of the tree to the text that made it.
TEST(CallText, OfANodeOfTheTree) {
    const auto evaluation = test::run("include <a.scad>\nm(2);",
                                      {{"a.scad", "\xEF\xBB\xBFmodule m(x) {\r\n  /* \xC3\xB6 */ cube([x, 4]); }"}})
                                .evaluation;
    ASSERT_NE(evaluation.tree, nullptr);
    const csg::Tree& tree = *evaluation.tree;
    const csg::SourceLocation where = tree.node(tree.children(tree.children(tree.root())[0])[0]).where;
    evaluation.program->look([&](const Program& program) {
        std::uint32_t file = 0;
        while (program.sources[file].name() != tree.files()[where.file]) {
            ++file;
        }
        EXPECT_EQ(program.sources[file].mark_bytes(), 3U);
        EXPECT_EQ(shown(program, call_at(program, {file, where.line, where.column})),
                  "cube([x, 4]) = {[x, 4]|[x, 4]: 4}");
        EXPECT_EQ(shown(program, call_at(program, {file, where.line, where.column + 1})), "none");
    });
}

TEST(CallText, LiteralAtAByte) {
    const std::string text = "a = -12 + \"x\";\nb = [true,3];";
    const auto parsed = test::parse(text);
    std::string all;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const auto literal = literal_at(parsed.program, 0, at);
        all += literal ? fmt::format("{},", cut(parsed.program, 0, literal->bytes)) : ".";
    }
    EXPECT_EQ(all, "....-12,-12,-12,-12,..\"x\",\"x\",\"x\",\"x\",......true,true,true,true,true,3,3,.");
}

TEST(SourceOffsets, GoBothWays) {
    for (const char* text : {"", "\n", "a\nb\r\nc\rd", "\r\r\n\n", "abc"}) {
        const SourceFile file("a", text);
        for (std::size_t at = 0; at <= std::string(text).size(); ++at) {
            const auto place = file.place(at);
            EXPECT_EQ(file.offset(place.line, place.column), at) << text;
        }
    }
    EXPECT_EQ(SourceFile("a", "ab\ncd").place(4), (csg::SourceLocation{0, 2, 2}));
    EXPECT_EQ(SourceFile("a", "ab\ncd").offset(7, 1), 5U);
}

}  // namespace
