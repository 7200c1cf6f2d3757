// The cases of OpenSCAD's suite that pass, by name in conformance_expected.txt: none may be lost, and none forgotten.
#include "tests/csg/scad/conformance.h"
#include "tests/support/suite.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>

namespace {

std::set<std::string> expected_names() {
    std::ifstream in(std::string(CSGSCOPE_SOURCE_DIR) + "/tests/csg/scad/conformance_expected.txt");
    std::set<std::string> names;
    for (std::string line; std::getline(in, line);) {
        if (!line.empty() && !line.starts_with('#')) {
            names.insert(line);
        }
    }
    return names;
}

void run_kind(const std::string& kind) {
    const auto cases = conformance::cases();
    if (cases.empty()) {
        GTEST_SKIP() << "no conformance data in " << suite::folder();
    }
    const auto expected = expected_names();
    std::size_t passed = 0, all = 0;
    for (const auto& c : cases) {
        if (c.kind != kind) {
            continue;
        }
        ++all;
        const std::string difference = conformance::difference(c);
        passed += difference.empty();
        if (expected.contains(c.name)) {
            EXPECT_EQ(difference, "") << c.name;
        } else if (difference.empty()) {
            ADD_FAILURE() << c.name << " passes: add it to conformance_expected.txt";
        } else if (std::getenv("CSGSCOPE_SHOW_FAILURES") != nullptr) {
            std::cout << c.name << ": " << difference << "\n";
        }
    }
    std::cout << kind << ": " << passed << " of " << all << " pass\n";
}

TEST(Conformance, Echo) {
    run_kind("echo");
}
TEST(Conformance, Csg) {
    run_kind("csg");
}
TEST(Conformance, LazyUnion) {
    run_kind("lazyunion");
}

}  // namespace
