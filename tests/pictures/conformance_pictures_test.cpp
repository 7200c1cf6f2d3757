// The pictures of OpenSCAD's suite whose silhouettes are the same, by name in expected.txt: none may be lost.
#include "tests/pictures/conformance_pictures.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "tests/pictures/silhouette.h"
#include "tests/support/suite.h"
#include "tests/support/temporary_folder.h"

namespace {

/// Gray, with a white rectangle from (x, y) on.
base::Image rectangle(int x, int y, int width, int height) {
    base::Image image{20, 10, std::vector<std::uint8_t>(20 * 10 * 4, 128)};
    for (int j = y; j < y + height; ++j) {
        for (int i = x; i < x + width; ++i) {
            std::fill_n(image.rgba.begin() + 4 * (j * 20 + i), 4, std::uint8_t{255});
        }
    }
    return image;
}

TEST(Silhouettes, OverlapByIntersectionOverUnion) {
    EXPECT_EQ(pictures::background(rectangle(2, 2, 4, 4)), (pictures::Background{128, 128, 128}));
    EXPECT_DOUBLE_EQ(pictures::overlap(rectangle(2, 2, 4, 4), rectangle(2, 2, 4, 4)), 1);
    EXPECT_DOUBLE_EQ(pictures::overlap(rectangle(2, 2, 4, 4), rectangle(4, 2, 4, 4)), 8.0 / 24);
    EXPECT_DOUBLE_EQ(pictures::overlap(rectangle(2, 2, 4, 4), rectangle(9, 2, 4, 4)), 0);
    EXPECT_DOUBLE_EQ(pictures::overlap(rectangle(2, 2, 0, 0), rectangle(2, 2, 0, 0)), 1);
}

TEST(ConformancePictures, NoneIsLost) {
    std::vector<pictures::Case> cases = pictures::cases();
    if (cases.empty()) {
        GTEST_SKIP() << "no conformance data in " << suite::folder();
    }
    std::set<std::string> names;
    std::ifstream in(CSGSCOPE_SOURCE_DIR "/tests/pictures/expected.txt");
    for (std::string line; std::getline(in, line);) {
        if (!line.empty() && !line.starts_with('#')) {
            names.insert(line);
        }
    }
    std::erase_if(cases, [&](const pictures::Case& c) { return !names.contains(c.name); });
    EXPECT_EQ(cases.size(), names.size()) << "expected.txt names cases that there are not";
    const test_support::TemporaryFolder folder;
    const auto results = pictures::draw(CSGSCOPE_PROGRAM, cases, folder.path(""));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        EXPECT_TRUE(results[i].good()) << cases[i].name << ": overlap " << results[i].overlap << " "
                                       << results[i].problem;
    }
}

}  // namespace
