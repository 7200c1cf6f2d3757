// What nobody can wait for, or has the memory for, is refused at once, with a reason.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <ostream>
#include <string>

#include "tests/support/program_test.h"

namespace {

struct Refused {
    const char* name;
    const char* program;
    const char* reason;  ///< What standard error says.
};

void PrintTo(const Refused& refused, std::ostream* out) {
    *out << refused.name;
}

const Refused kRefused[] = {
    {"segments_of_a_sphere", "sphere(10, $fn = 8000);", "sphere has more than 16777216 triangles"},
    {"triangles_of_all", "for (i = [0:999]) translate([i, 0, 0]) sphere(1, $fn = 400);",
     "the model has more than 67108864 triangles"},
    {"doubled_texts", "function f(s, n) = n == 0 ? s : f(str(s, s), n - 1); echo(len(f(\"0123456789abcdef\", 50)));",
     "Lists hold more than"},
    {"doubled_lists", "function f(s, n) = n == 0 ? s : f(concat(s, s), n - 1); echo(len(f([1], 50)));",
     "Lists hold more than"},
    {"long_ranges", "for (i = [0:1e9]) cube(i);", "too many elements"},
};

class Bounds : public test_support::ProgramTest, public testing::WithParamInterface<Refused> {
  protected:
    Bounds() : ProgramTest(60) {}
};

TEST_P(Bounds, AreTold) {
    folder_.write("model.scad", GetParam().program);
    const Result result = run("model.scad -o model.png --imgsize 64,64");
    EXPECT_NE(result.status, -1);
    EXPECT_NE(result.err.find(GetParam().reason), std::string::npos) << result.err.substr(0, 1000);
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    EXPECT_LT(usage.ru_maxrss, 3 << 20);  // KiB, of the largest child.
}

INSTANTIATE_TEST_SUITE_P(Programs, Bounds, testing::ValuesIn(kRefused),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
