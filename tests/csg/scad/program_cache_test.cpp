// Programs that are loaded once and run often: every run says and makes what the first one would.
#include <gtest/gtest.h>

#include <thread>

#include "tests/csg/scad/evaluate_text.h"
#include "tests/support/temporary_folder.h"

namespace {

using csg::scad::ProgramCache;
using csg::scad::Request;
using Files = std::map<std::string, std::string>;

class Kept : public testing::Test {
  protected:
    /// Runs with what is kept, and expects what a run from nothing gives.
    test::Run run(const std::string& text, const Files& files = {}, const Request& request = {}) {
        test::Run kept = test::run_kept(cache_, text, files, request);
        test::expect_same(kept, test::run(text, files, request));
        return kept;
    }
    test::Run define(const std::string& text, std::vector<std::string> definitions, const Files& files = {}) {
        SCOPED_TRACE(testing::PrintToString(definitions));
        Request request;
        request.definitions = std::move(definitions);
        return run(text, files, request);
    }
    [[nodiscard]] std::size_t parsed() const { return cache_.counts().parsed; }

    ProgramCache cache_;
};

TEST_F(Kept, RunsAgainWithoutParsing) {
    const Files files{{"a.scad", "a = [1, 2, \"x\"]; function f(x) = [x, a, 3]; module m(b) { echo(b); cube(b); }"},
                      {"b.scad", "$fn = 7; function g(x) = let (y = function (z) z + x) y(2); module n() m(g(3));"}};
    const std::string text = "include <a.scad>\nuse <b.scad>\nm(2); n(); echo(f(1), g(1), $t, $vpd);\nfoo();";
    for (int i = 0; i < 3; ++i) {
        Request request;
        request.time = i;
        request.view.distance = 100 + i;
        (void)run(text, files, request);
    }
    EXPECT_EQ(parsed(), 1U);
    EXPECT_EQ(cache_.counts().kept, 2U);
}

TEST_F(Kept, WhatTheParserSaysIsSaidInEveryRun) {
    const Files files{{"a.scad", "b = 1;\nb = \"\\q\";"}, {"b.scad", "b = 1;\nb = 2;\nmodule x() {"}};
    for (const std::string text :
         {"a = 1;\na = 2;\ninclude <a.scad>\nuse <none.scad>\ninclude <none.scad>\necho(a);",
          "a = \"\\q\";\nuse <b.scad>\nassign(a = 3) x();", "a = 1;\ncube(", "include <b.scad>"}) {
        for (int i = 0; i < 3; ++i) {
            (void)run(text, files);
        }
    }
    EXPECT_EQ(parsed(), 4U);
}

TEST_F(Kept, TracesAreThoseOfTheFirstRun) {
    const std::string text =
        "a = 1;\nmodule m(x) { n(x); }\nmodule n(y) { assert(f(y) > 3, \"no\"); }\n"
        "function f(z) = g(z) + a;\nfunction g(z) = assert(z < 3) z;\na = 2;\nm(t);\nt = 1;";
    for (const char* t : {"t=1", "t=5", "t=2", "t=5", "t=1"}) {
        (void)define(text, {t});
    }
    EXPECT_EQ(parsed(), 1U);
}

TEST_F(Kept, DefinitionsComeAndGo) {
    const std::string text =
        "a = 1;\nb = [a, 2];\na = 3;\nmodule m(x = b) echo(x, a, $fn, is_undef(q) ? 0 : q, $z);\nm();\n"
        "function f(n) = n == 0 ? b : f(n - 1);\necho(f(3), is_undef(h) ? 0 : h(2));\nsphere(1);";
    const std::vector<std::vector<std::string>> all{
        {},
        {"a=5"},
        {"a=6"},
        {"a=5", "a=7"},
        {"b=[for (i = [0:3]) i * a]"},
        {"$fn=12"},
        {"$fn=5", "$z=\"z\""},
        {"q=1"},
        {"q=2", "a=1"},
        {"a=1", "q=2"},
        {"h=function (x) x * a"},
        {"r=3; a=r + 1;"},
        {"a=\"\\q\""},
        {"a="},
        {"a=1", "b"},
        {"a=a"},
        {"b=let (c = a) [c, c]"},
        {"c=1 < 2"},
        {"$vpd=7", "$vpt=[1, 2]"},
        {"m=1"},
        {"f=2"},
    };
    for (std::size_t step = 1; step <= 5; ++step) {  // All in an order, and in others.
        for (std::size_t i = 0; i < all.size(); ++i) {
            (void)define(text, all[i * step % all.size()]);
        }
    }
    EXPECT_EQ(parsed(), 1U);
}

TEST_F(Kept, DefinitionsThatAreWrongFromTheFirst) {
    const Files files{{"a.scad", "include <c.scad>\nx = 1;"}, {"c.scad", "y = 1;\ny = 2;"}};
    const std::string text = "use <a.scad>\na = 1;\necho(a);";
    for (const char* definition : {"a=", "a=2", "a=", "a=3"}) {
        (void)define(text, {definition}, files);
    }
}

TEST_F(Kept, DefinitionsThatNameFiles) {
    const Files files{{"a.scad", "v = 4;"}, {"b.scad", "v = 5;"}};
    const std::string text = "v = 1;\necho(v);";
    for (const char* definition : {"include <a.scad>", "include <b.scad>", "v=2", "include <a.scad>", "use <a.scad>",
                                   "v=1; include <none.scad>", "include=1 < 2"}) {
        (void)define(text, {definition}, files);
    }
}

TEST_F(Kept, ManyDefinitionsLeaveLittleBehind) {
    Request request;
    for (int i = 0; i < 3000; ++i) {
        request.definitions = {"a=" + std::to_string(i), "b=[for (i = [0:" + std::to_string(i) + "]) i]"};
        const test::Run kept = test::run_kept(cache_, "a = 1; b = 2; echo(a, len(b));", {}, request);
        EXPECT_EQ(kept.console, "ECHO: " + std::to_string(i) + ", " + std::to_string(i + 1) + "\n");
    }
    EXPECT_EQ(parsed(), 1U);
}

TEST_F(Kept, OnlyWhatChangedIsNoticed) {
    Files files{{"a.scad", "include <b.scad>\na = 1;"}, {"b.scad", "b = 1;"}};
    const std::string text = "include <a.scad>\ninclude <c.scad>\necho(a, b, c);";
    (void)run(text, files);
    (void)run(text, files);
    EXPECT_EQ(parsed(), 1U);
    files["b.scad"] = "b = 2;";
    (void)run(text, files);
    EXPECT_EQ(parsed(), 2U);
    files["c.scad"] = "c = 3;";  // It was missing.
    (void)run(text, files);
    EXPECT_EQ(parsed(), 3U);
    files["unused.scad"] = "c = 3;";
    (void)run(text, files);
    EXPECT_EQ(parsed(), 3U);
    files.erase("a.scad");
    (void)run(text, files);
    (void)run(text + " ", files);
    EXPECT_EQ(parsed(), 5U);
}

/// What an edit of one file makes parse.
TEST_F(Kept, AnEditParsesTheEditedFileOnly) {
    Files files;
    std::string text;
    for (int i = 0; i < 20; ++i) {
        const std::string n = std::to_string(i);
        files["f" + n + ".scad"] =
            "a" + n + " = " + n + "; function f" + n + "(x) = [x, a" + n + ", \"t" + n + "\"];\nmodule m" + n +
            "(x = [1, -2]) { echo(f" + n + "(x)); cube(x[0]); }\n" +
            (i % 3 == 1 ? "use <f" + std::to_string(i - 1) + ".scad>\nb" + n + " = f" + std::to_string(i - 1) + "(2);\n"
                        : "");
        text += (i % 3 == 0 ? "use <f" : "include <f") + n + ".scad>\nm" + n + "();\n";
    }
    (void)run(text, files);
    EXPECT_EQ(cache_.counts().pieces, 20U);
    files["f7.scad"] += "// A comment.\n";
    (void)run(text, files);
    EXPECT_EQ(cache_.counts().pieces, 21U);
    files["f8.scad"] = "a8 = 3;\na8 = 4;\nmodule m8() echo(a8, a7, b7);";  // Not a piece in all programs: it warns.
    (void)run(text, files);
    EXPECT_EQ(cache_.counts().pieces, 22U);
    (void)run(text + "echo(a8);", files);
    EXPECT_EQ(cache_.counts().pieces, 22U);
    EXPECT_EQ(parsed(), 4U);
}

/// Files that end in the middle of something, or go on where another has ended.
TEST_F(Kept, FilesThatAreNoPieces) {
    const std::vector<std::string> ends{"translate([1, 0, 0])",
                                        "x = 1 +",
                                        "module m() {",
                                        "if (true) cube(1);",
                                        "difference() { cube(2);",
                                        "function f(x) =",
                                        "a = 1;;",
                                        "{ }",
                                        "m(",
                                        "a = 2"};
    const std::vector<std::string> goes_on{"cube(3);",
                                           "2; echo(x);",
                                           "} m();",
                                           "else sphere(1);",
                                           "sphere(1); }",
                                           "x; echo(f(1));",
                                           "a = 3; a = 4;",
                                           "include <none.scad>\n;",
                                           "3);",
                                           ";",
                                           "a = \"\\q\";",
                                           "\"\\q\" = 2;",
                                           "use <none.scad>\na = 5;"};
    for (const std::string& end : ends) {
        for (const std::string& begin : goes_on) {
            SCOPED_TRACE(end + "|" + begin);
            const Files files{{"a.scad", "v = 1;\n" + end}, {"b.scad", begin}, {"c.scad", end}, {"d.scad", "a = 7;"}};
            for (const std::string text : {"include <a.scad>\ninclude <b.scad>", "a = 0;\ninclude <a.scad>\n",
                                           "a = 1;\na = 2;\ninclude <b.scad>\ninclude <d.scad>\na = \"\\q\";",
                                           "use <a.scad>\nv = 2;\ninclude <c.scad>\n", "{ include <d.scad>\n }"}) {
                (void)run(text, files);
                (void)run(text + begin, files);
            }
        }
    }
}

TEST_F(Kept, LimitsAreThoseOfEachRun) {
    const std::string text =
        "function f(n) = n == 0 ? [] : [n, f(n - 1)];\na = [\"xxxxxxxxxxxxxxxxxxxx\", 2, 3];\n"
        "echo(len(f(n)));\nn = 10; module m(n) { if (n > 0) m(n - 1); } m(n);";
    Request request;
    for (const std::size_t most : {1000U, 15U, 22U, 23U, 24U, 1000U, 20U}) {
        request.limits.list_elements = most;
        (void)run(text, {}, request);
    }
    request.limits = {};
    request.limits.stack_bytes = std::size_t{16} << 20;
    for (const char* n : {"n=10", "n=1e6", "n=10", "n=1e7", "n=100"}) {
        request.definitions = {n};
        (void)run(text, {}, request);
    }
    EXPECT_EQ(parsed(), 1U);
}

/// A definition with its semicolon is a file that could be parsed by itself; it is taken apart all the same.
TEST_F(Kept, DefinitionsMayEndWithSemicolons) {
    const std::string text = "a = 1; b = 2; echo(a, b);";
    for (const char* const definition : {"a=3;", "a=4; ", "a=5;b=6;", "a=7;b=8", ";", "a=9;;"}) {
        (void)define(text, {definition});
    }
    EXPECT_NE(define(text, {"a=3;"}).console.find("3, 2"), std::string::npos);
}

TEST_F(Kept, StopsAndGoesOn) {
    const std::string text = "function f(n) = n <= 1 ? 1 : f(n - 1) + f(n - 2);\necho(f(n));\nn = 5;";
    (void)define(text, {});
    std::stop_source stop;
    Request request;
    request.definitions = {"n=60"};
    request.stop = stop.get_token();
    std::thread stopper([&stop] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        stop.request_stop();
    });
    EXPECT_TRUE(test::run_kept(cache_, text, {}, request).evaluation.stopped);
    stopper.join();
    (void)define(text, {"n=10"});
}

TEST_F(Kept, RunsFromSeveralThreads) {
    const std::string text = "include <a.scad>\necho(a, f(a)); for (i = [0:a]) cube([i, 1, \"x\" == \"x\" ? 1 : 2]);";
    const Files files{{"a.scad", "a = 3; function f(x) = [\"t\", [1, 2], x];"}};
    const test::Run expected = test::run(text, files);
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
            for (int k = 0; k < 50; ++k) {
                const test::Run run = test::run_kept(cache_, text, files);
                EXPECT_EQ(run.console, expected.console);
                EXPECT_EQ(run.csg, expected.csg);
            }
        });
    }
    threads.clear();
    EXPECT_EQ(parsed(), 1U);
}

TEST_F(Kept, WhatIsMadeIsMadeOnce) {
    Files files{{"b.scad", "b = 1;"}};
    std::vector<std::string> made;
    Request request;
    request.path = "main.scad";
    request.text = "include <a.scad>\nuse <sub/c.scad>\ninclude <b.scad>\necho(a, b);";
    request.search_path = {"library"};
    request.reader = [&](const std::string& path) -> csg::scad::ReadResult {
        const auto found = files.find(path);
        return found == files.end() ? csg::scad::ReadResult(csg::scad::ReadError{true, ""}) : found->second;
    };
    request.make_missing = [&](const std::string& path) {
        made.push_back(path);
        if (path == "a.scad") {
            files[path] = "a = 1;";
        }
    };
    const auto evaluate = [&] {
        made.clear();
        std::string console;
        const auto result = cache_.evaluate(
            request, [&](const auto& message, const auto& sources) { console += render_openscad(message, sources); });
        EXPECT_EQ(result.files.size(), 3U);
        EXPECT_EQ(console, "WARNING: Can't open library 'sub/c.scad'. in file main.scad, line 2ECHO: 1, 1");
        return made;
    };
    EXPECT_EQ(evaluate(), (std::vector<std::string>{"a.scad", "sub/c.scad"}));
    EXPECT_EQ(evaluate(), (std::vector<std::string>{"sub/c.scad"}));
    EXPECT_EQ(evaluate(), (std::vector<std::string>{"sub/c.scad"}));
    files.erase("a.scad");
    EXPECT_EQ(evaluate(), (std::vector<std::string>{"a.scad", "sub/c.scad"}));
}

TEST_F(Kept, TheProgramAndItsTextsOutliveTheCache) {
    const std::string text = "a = 1;\ncube(a);";
    csg::scad::Evaluation evaluation;
    {
        ProgramCache cache;
        evaluation = test::run_kept(cache, text).evaluation;
        (void)test::run_kept(cache, "sphere();");
    }
    ASSERT_NE(evaluation.program, nullptr);
    EXPECT_EQ((*evaluation.sources)[0].text(), text);
    EXPECT_EQ(evaluation.program->look([](const csg::scad::Program& p) { return p.sources[0].text(); }), text);
}

TEST_F(Kept, FilesOnDiskAreLookedForAndToldOf) {
    test_support::TemporaryFolder folder;
    Request request;
    request.path = folder.write("main.scad", "include <a.scad>\ninclude <b.scad>\necho(a);");
    folder.write("a.scad", "a = 1;");
    request.search_path.clear();
    std::string console;
    const auto sink = [&](const auto& message, const auto& sources) { console += render_openscad(message, sources); };
    const auto names = [&] {
        console.clear();
        std::string all;
        for (const auto& [path, state] : cache_.evaluate(request, sink).looked_for) {
            EXPECT_EQ(state, csg::scad::disk_state(path));
            all += path.substr(folder.path("").size()) + (state.exists ? " " : "? ");
        }
        return all;
    };
    EXPECT_EQ(names(), "main.scad a.scad b.scad? ");
    EXPECT_EQ(names(), "main.scad a.scad b.scad? ");
    EXPECT_EQ(parsed(), 1U);
    folder.replace("a.scad", "a = 2;");
    EXPECT_EQ(names(), "main.scad a.scad b.scad? ");
    EXPECT_TRUE(console.ends_with("ECHO: 2")) << console;
    folder.remove("main.scad");
    EXPECT_EQ(names(), "main.scad? ");
    EXPECT_EQ(console, test::run("", {}).console + "ERROR: cannot read " + request.path + ": no such file");
}

}  // namespace
