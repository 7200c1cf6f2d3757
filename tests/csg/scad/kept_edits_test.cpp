// Random edits of files, definitions and variables: what is kept of a program never shows.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/csg/scad/evaluate_text.h"

namespace {

using Files = std::map<std::string, std::string>;

/// Pieces of programs; some of them are not well formed, and some do not end where a statement does.
const std::vector<std::string>& pieces() {
    static const std::vector<std::string> all{
        "a = 1;",
        "a = 2;\nb = a + 1;",
        "b = [1, a, \"t\"];",
        "c = [for (i = [0:3]) i * 2];",
        "$fn = 5;",
        "$fn = a;",
        "function f(x) = [x, a, $fn];",
        "function f(x) = x > 0 ? f(x - 1) : \"end\";",
        "function g(x, y = b) = let (z = f(x)) [z, y];",
        "module m(x = 1) { echo(x, a); cube(x); }",
        "module m(x) { n(); children(); }",
        "module n() { d = 3; function h() = d; echo(h(), f(2)); sphere(d); }",
        "m(2);",
        "m(3) n();",
        "n(); unknown(3);",
        "echo(f(2), g(1), a, b, c);",
        "echo(undefined_variable);",
        "if (a == 1) m(1);",
        "else n();",
        "translate([a, 0, 0])",
        "difference() { cube(4);",
        "}",
        "x = ",
        ";",
        "assert(a == 1, \"a\");",
        "s = \"\\q\";",
        "include <a.scad>",
        "include <b.scad>",
        "include <c.scad>",
        "include <none.scad>",
        "use <a.scad>",
        "use <b.scad>",
        "use <d.scad>",
        "use <font.ttf>",
        "module big(x, y = [1, 2, 3]) { for (i = y) if (i > x) translate([i, x]) big(i, [i]); else echo(i, x, y); }",
        "big(2);",
        "h = function (x) x + a;\necho(h(1));",
        "// a comment\n/* another */ a = 3; /* third */",
        "assign(p = 3) echo(p);",
        "intersection_for (i = [1:2]) rotate(i) square(a);",
    };
    return all;
}

std::string random_text() {
    std::string text;
    for (int count = *rc::gen::inRange(0, 7); count > 0; --count) {
        text += *rc::gen::elementOf(pieces()) + (*rc::gen::inRange(0, 3) == 0 ? " " : "\n");
    }
    return text;
}

TEST(KeptEdits, AreAsALoadFromNothing) {
    EXPECT_TRUE(rc::check("sequences of edits", [] {
        static const std::vector<std::string> definitions{"a=1",   "a=4",       "b=2", "q=3",
                                                          "$fn=9", "s=\"\\q\"", "f=1", "a="};
        csg::scad::ProgramCache cache;
        std::string text = random_text();
        Files files;
        for (const char* name : {"a.scad", "b.scad", "c.scad", "d.scad"}) {
            files[name] = random_text();
        }
        csg::scad::Request request;
        request.limits.stack_bytes = std::size_t{16} << 20;
        request.limits.nodes = 1000;
        request.limits.list_elements = 10'000;
        for (int step = 0; step < 12; ++step) {
            const int what = *rc::gen::inRange(0, 8);
            if (what < 2) {
                text = random_text();
            } else if (what < 4) {
                files[*rc::gen::element<std::string>("a.scad", "b.scad", "c.scad", "d.scad")] = random_text();
            } else if (what == 4) {
                files.erase(*rc::gen::element<std::string>("a.scad", "b.scad", "c.scad", "d.scad"));
            } else if (what < 7) {
                request.definitions = *rc::gen::container<std::vector<std::string>>(
                    *rc::gen::inRange<std::size_t>(0, 3), rc::gen::elementOf(definitions));
            } else {
                request.time = step;
            }
            const test::Run fresh = test::run(text, files, request);
            const test::Run kept = test::run_kept(cache, text, files, request);
            RC_ASSERT(kept.console == fresh.console);
            RC_ASSERT(kept.csg == fresh.csg);
            RC_ASSERT(kept.evaluation.files == fresh.evaluation.files);
            RC_ASSERT(kept.evaluation.ok == fresh.evaluation.ok);
        }
    }));
}

}  // namespace
