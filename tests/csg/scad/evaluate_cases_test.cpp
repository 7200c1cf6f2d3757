// Programs with what they print and the tree they make: cases/*.txt. A case is a line `#### name`, the program, files
// it uses (each after a line `@@ name`), a line `----`, what the console shows, and the .csg text. With
// CSGSCOPE_UPDATE_GOLDENS set the expectations are written anew, to be looked at in the diff.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "tests/csg/scad/evaluate_text.h"
#include "tests/support/sanitizer.h"

namespace {

namespace fs = std::filesystem;

struct Case {
    std::string name;
    std::string program;
    std::map<std::string, std::string> files;
    std::string expected;
};

std::vector<Case> read_cases(const fs::path& path) {
    std::vector<Case> cases;
    std::ifstream in(path);
    std::string* part = nullptr;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("#### ")) {
            cases.push_back({line.substr(5), {}, {}, {}});
            part = &cases.back().program;
        } else if (line.starts_with("@@ ")) {
            part = &cases.back().files[line.substr(3)];
        } else if (line == "----") {
            part = &cases.back().expected;
        } else {
            *part += line + '\n';
        }
    }
    return cases;
}

void write_cases(const fs::path& path, const std::vector<Case>& cases) {
    std::ofstream out(path);
    for (const Case& c : cases) {
        out << "#### " << c.name << '\n' << c.program;
        for (const auto& [name, text] : c.files) {
            out << "@@ " << name << '\n' << text;
        }
        out << "----\n" << c.expected;
    }
}

class EvaluateCases : public testing::TestWithParam<std::string> {};

TEST_P(EvaluateCases, AsExpected) {
    const fs::path path = fs::path(CSGSCOPE_SOURCE_DIR) / "tests/csg/scad/cases" / (GetParam() + ".txt");
    std::vector<Case> cases = read_cases(path);
    ASSERT_FALSE(cases.empty()) << path;
    const bool update = std::getenv("CSGSCOPE_UPDATE_GOLDENS") != nullptr;
    csg::scad::Request request;
    if (test_support::kAddressSanitizer) {
        request.limits.stack_bytes *= 4;  // Frames are several times as large.
    }
    csg::scad::ProgramCache cache;
    for (Case& c : cases) {
        SCOPED_TRACE(c.name);
        const test::Run run = test::run(c.program, c.files, request);
        for (int again = 0; again < 2; ++again) {
            test::expect_same(test::run_kept(cache, c.program, c.files, request), run);
        }
        const std::string got = run.console + run.csg;
        EXPECT_EQ(run.evaluation.ok, run.evaluation.errors == 0) << c.name;
        EXPECT_EQ(run.evaluation.ok, run.evaluation.tree != nullptr) << c.name;
        if (update) {
            c.expected = got;
        } else {
            EXPECT_EQ(got, c.expected) << "in case '" << c.name << "' of " << path;
        }
    }
    if (update) {
        write_cases(path, cases);
    }
}

std::vector<std::string> case_files() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(CSGSCOPE_SOURCE_DIR) / "tests/csg/scad/cases")) {
        names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Files, EvaluateCases, testing::ValuesIn(case_files()),
                         [](const testing::TestParamInfo<std::string>& info) { return info.param; });

}  // namespace
