// Programs that would never end, or take all memory, end with an error that says where, and soon.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <ctime>
#include <thread>

#include "tests/csg/scad/evaluate_text.h"

namespace {

struct Endless {
    const char* name;
    const char* program;
    const char* says;  ///< What the console says, among other things. Where it is no error there is a tree.
};

class Limits : public testing::TestWithParam<Endless> {};

constexpr Endless kEndless[] = {
    {"Function", "function f(n) = 1 + f(n + 1);\necho(f(0));",
     "ERROR: Recursion detected calling function 'f' in file case.scad, line 1"},
    {"FunctionInTailPosition", "function f(n) = f(n + 1);\necho(f(0));",
     "ERROR: Recursion detected calling function 'f' in file case.scad, line 1"},
    {"FunctionValue", "f = function(g, n) 1 + g(g, n);\necho(f(f, 0));", "ERROR: Recursion detected calling function"},
    {"FunctionInList", "function f(n) = [for (i = [0:1]) f(n + 1)];\necho(f(0));", "ERROR: Recursion detected"},
    {"FunctionInDefault", "function f(n = f()) = n;\necho(f());", "ERROR: Recursion detected"},
    {"FunctionInLet", "function f(n) = let(m = f(n + 1)) m;\necho(f(0));", "ERROR: Recursion detected"},
    {"FunctionInAssert", "function f(n) = assert(f(n + 1)) n;\necho(f(0));", "ERROR: Recursion detected"},
    {"TwoFunctions", "function f(n) = 1 + g(n);\nfunction g(n) = 1 + f(n);\necho(f(0));", "ERROR: Recursion detected"},
    {"Module", "module m() m();\nm();", "ERROR: Recursion detected calling module 'm' in file case.scad, line 1"},
    {"ModuleWithArguments", "module m(a) { b = [a, a]; m(b); }\nm(1);", "ERROR: Recursion detected calling module 'm'"},
    {"ModuleInFor", "module m() for (i = [0:1]) translate([i, 0, 0]) m();\nm();", "ERROR: Recursion detected"},
    {"ModuleInIf", "module m() if (true) m();\nm();", "ERROR: Recursion detected"},
    {"ModuleInAssignment", "function f() = g();\nfunction g() = 1 + f();\nmodule m() { a = f(); }\nm();",
     "ERROR: Recursion detected"},
    {"Children", "module m() { m() children(); }\nm() cube();", "ERROR: Recursion detected"},
    {"ForInExpression", "echo([for (i = 0; true; i = i + 1) i]);", "ERROR: For loop counter exceeded limit"},
    {"ForThatMakesNothing", "echo([for (i = 0; true; i = i) if (false) i]);", "ERROR: For loop counter exceeded limit"},
    {"HugeRange", "x = [for (i = [0:1e9]) i];\necho(len(x));", "too many elements (1000000001)"},
    {"HugeRangeOfModules", "for (i = [0:1e9]) cube(i);", "too many elements (1000000001)"},
    {"HugeRangeToText", "echo(chr([0:1e9]));", "expected no more than 1000000 items"},
    {"EachOfHugeRange", "echo(len([each [0:1e9]]));", "too many elements"},
    {"NestedRanges", "x = [for (i = [0:99999], j = [0:99999]) i];", "ERROR: Lists hold more than 10000000 elements"},
    {"DoubledList", "function f(n, v) = f(n + 1, concat(v, v));\necho(f(0, [1]));",
     "ERROR: Lists hold more than 10000000 elements"},
    {"DoubledString", "function f(n, s) = f(n + 1, str(s, s));\necho(f(0, \"a\"));",
     "ERROR: Lists hold more than 10000000 elements"},
    {"ManyRandomNumbers", "echo(len(rands(0, 1, 1e9)));", "rands() cannot create more than"},
    {"DeepListToText", "function f(n) = n == 0 ? [] : let(x = f(n - 1)) [x, x];\necho(f(60));",
     "ERROR: A list is too long to be converted to text in file case.scad, line 2"},
    {"DeepListCompared", "function f(n) = n == 0 ? [] : let(x = f(n - 1)) [x, x];\necho(f(60) == f(60));",
     "ERROR: The lists are too large to compare"},
    {"DeepListOrdered", "function f(n) = n == 0 ? [1] : let(x = f(n - 1)) [x, x];\necho(f(60) < f(60));",
     "ERROR: The lists are too large to compare"},
    {"DeepListNegated", "function f(n) = n == 0 ? 1 : let(x = f(n - 1)) [x, x];\na = -f(60);",
     "ERROR: Lists hold more than 10000000 elements"},
    {"DeepListMultiplied", "function f(n) = n == 0 ? 1 : let(x = f(n - 1)) [x, x];\na = 2 * f(60);",
     "ERROR: Lists hold more than 10000000 elements"},
    {"DeepListToCharacters", "function f(n) = n == 0 ? 0 : let(x = f(n - 1)) [x, x];\na = chr(f(60));",
     "ERROR: A list is too long to be converted to text in file case.scad, line 2"},
    {"DeepListSearched", "function f(n) = n == 0 ? 0 : let(x = f(n - 1)) [x, x];\na = search([f(60)], [f(60)]);",
     "ERROR: The lists are too large to compare in file case.scad, line 2"},
    {"NestedList", "function f(n, v) = n == 0 ? v : f(n - 1, [v]);\na = f(500000, 1);\necho(len(a), a == a);",
     "ECHO: 1, true\n"},
    {"NestedListToText", "function f(n, v) = n == 0 ? v : f(n - 1, [v]);\necho(f(500000, 1));",
     "ERROR: Stack exhausted while trying to convert a vector to EchoString"},
    {"NestedListAdded",
     "function f(n, v) = n == 0 ? v : f(n - 1, [v]);\na = f(500000, 1) + f(500000, 1);\necho(len(a));", "ECHO: 1\n"},
    {"NestedClosures", "function f(n, g) = n == 0 ? g : f(n - 1, function() g);\na = f(500000, 1);\necho(1);",
     "ECHO: 1\n"},
    {"ManyNodes",
     "module m(n) { if (n > 0) { m(n - 1); m(n - 1); } else translate([rands(0, 1, 1)[0], 0, 0]) cube(); }\n"
     "m(40);",
     "ERROR: The model has more than 100000 nodes"},
};

TEST_P(Limits, EndsSoon) {
    csg::scad::Request request;
    request.limits.list_elements = 10'000'000;
    request.limits.nodes = 100'000;
    request.limits.stack_bytes = std::size_t{64} << 20;
    const std::clock_t begin = std::clock();  // Processor time: nothing here waits, and others may be at work.
    const test::Run run = test::run(GetParam().program, {}, request);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const std::string says = GetParam().says;
    ASSERT_FALSE(says.empty());
    EXPECT_NE(run.console.find(says), std::string::npos) << run.console.substr(0, 2000);
    EXPECT_EQ(run.evaluation.ok, !says.starts_with("ERROR: ")) << run.console.substr(0, 2000);
    EXPECT_EQ(run.evaluation.ok, run.evaluation.errors == 0);
    EXPECT_EQ(run.evaluation.ok, run.evaluation.tree != nullptr);
    EXPECT_LT(run.console.size(), std::size_t{1} << 20);
    EXPECT_LT(seconds, 30);  // Not a measure of speed: of not hanging, on any machine.
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    EXPECT_LT(usage.ru_maxrss, 3L << 20) << "KiB";
}

INSTANTIATE_TEST_SUITE_P(Programs, Limits, testing::ValuesIn(kEndless),
                         [](const testing::TestParamInfo<Endless>& info) { return info.param.name; });

std::string repeat(const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) {
        text += part;
    }
    return text;
}

TEST(Chains, AreAsLongAsAProgramMakesThem) {
    constexpr int kMany = 200'000;
    EXPECT_EQ(test::run("echo(0" + repeat(" + 1", kMany) + ");").console, "ECHO: 200000\n");
    EXPECT_EQ(test::run("echo(true" + repeat(" && true", kMany) + ", false" + repeat(" || 0", kMany) + ");").console,
              "ECHO: true, false\n");
    EXPECT_EQ(test::run("echo(" + repeat("false ? 1 : ", kMany) + "2);").console, "ECHO: 2\n");
    EXPECT_EQ(test::run("a = [1]; echo(a" + repeat("[0]", kMany) + ");").console, "ECHO: undef\n");
    constexpr int kDeep = 20'000;
    const test::Run run = test::run(repeat("if (false) cube(1); else ", kDeep) + "cube(2);");
    ASSERT_TRUE(run.evaluation.ok) << run.console.substr(0, 1000);
    EXPECT_EQ(run.evaluation.tree->size(), std::size_t{kDeep} + 2);  // Group in group, as OpenSCAD makes them.
}

TEST(Chains, OfCallsEndWithAnErrorWhereTheStackDoes) {
    csg::scad::Request request;
    request.limits.stack_bytes = std::size_t{16} << 20;
    const test::Run run = test::run("f = function() f; echo(f" + repeat("()", 300'000) + ");", {}, request);
    EXPECT_NE(run.console.find("ERROR: Recursion detected"), std::string::npos) << run.console.substr(0, 1000);
}

TEST(Stop, EndsARunningEvaluation) {
    for (const char* program : {
             "module m(n) { for (i = [0:999]) m(n + 1); }\nfor (i = [0:99999]) for (j = [0:99999]) if (false) cube();",
             "function f(n) = n == 0 ? 0 : f(n - 1) + f(n - 1);\necho(f(60));",
             "a = [for (i = [0:99999], j = [0:99999], k = [0:9999]) if (false) i];",
             "a = [for (k = [0:99999]) [for (i = 0; i < 999999; i = i + 1) if (false) i]];",
         }) {
        std::stop_source stop;
        csg::scad::Request request;
        request.stop = stop.get_token();
        std::thread stopper([&stop] {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            stop.request_stop();
        });
        const test::Run run = test::run(program, {}, request);
        stopper.join();
        EXPECT_FALSE(run.evaluation.ok);
        EXPECT_TRUE(run.evaluation.stopped) << run.console;
    }
}

}  // namespace
