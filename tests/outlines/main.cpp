// Random outlines against what their loops enclose from the definition:
// csgscope_outlines [--cases N] [--first SEED] [--scad]. Exit status 1: something is wrong.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "tests/outlines/checks.h"
#include "tests/outlines/random_loops.h"

int main(int count, char** arguments) {
    CLI::App app("Extrudes and revolves random outlines and checks volumes, meshes and points.");
    std::uint64_t cases = 1000, first = 1;
    bool scad = false;
    app.add_option("--cases", cases, "how many outlines");
    app.add_option("--first", first, "the seed of the first one");
    app.add_flag("--scad", scad, "only print them, one a line: the area, and a statement of OpenSCAD");
    CLI11_PARSE(app, count, arguments);
    std::uint64_t wrong = 0;
    for (std::uint64_t seed = first; seed < first + cases; ++seed) {
        const auto loops = outlines::random_loops(seed);
        if (scad) {
            const double area = clean(loops, csg::solid::FillRule::EvenOdd).area();
            std::cout << fmt::format("{:.17g} {}\n", area, outlines::as_scad(loops));
            continue;
        }
        if (const std::string problem = outlines::problem_of(loops, seed); !problem.empty()) {
            ++wrong;
            std::cout << fmt::format("{}: {}\n    {}\n", seed, problem, outlines::as_scad(loops));
        }
    }
    if (!scad) {
        std::cout << fmt::format("{} outlines, {} wrong\n", cases, wrong);
    }
    return wrong == 0 ? 0 : 1;
}
