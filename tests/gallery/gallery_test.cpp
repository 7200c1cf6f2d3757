// The pictures of the README are what the program draws today.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>

#include "base/image.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
const fs::path kRoot = CSGSCOPE_SOURCE_DIR;

/// Pictures that the program does not draw by itself.
const std::set<std::string> kTakenElsewhere{"torture_openscad.png", "filler_openscad.png", "window.png", "by_hand.png",
                                            "depictions.png"};

/// Share of pixels that differ by more than an eighth of the range in some channel. Another OpenGL driver may cover the
/// pixels of outlines a little differently; a style that has changed differs in far more.
double difference(const base::Image& a, const base::Image& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        bool far = false;
        for (std::size_t c = 0; c < 4; ++c) {
            far = far || std::abs(int{a.rgba[i + c]} - int{b.rgba[i + c]}) > 32;
        }
        different += far ? 1 : 0;
    }
    return 4.0 * static_cast<double>(different) / static_cast<double>(a.rgba.size());
}

TEST(Gallery, PicturesAreCurrent) {
    const test_support::TemporaryFolder folder;
    const std::string command =
        "CSGSCOPE='" CSGSCOPE_PROGRAM "' '" + (kRoot / "tools/gallery").string() + "' '" + folder.path("") + "' 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
    int compared = 0;
    for (const auto& entry : fs::directory_iterator(kRoot / "docs/pictures")) {
        const std::string file = entry.path().filename().string();
        if (!entry.is_regular_file() || kTakenElsewhere.contains(file)) {
            continue;
        }
        SCOPED_TRACE(file);
        ASSERT_TRUE(fs::exists(folder.path(file))) << "tools/gallery.txt does not name it";
        const base::Image today = base::read_png(folder.path(file)), kept = base::read_png(entry.path());
        ASSERT_EQ(today.width, kept.width);
        ASSERT_EQ(today.height, kept.height);
        EXPECT_LT(difference(today, kept), 0.01) << "tools/gallery draws it anew";
        ++compared;
    }
    EXPECT_GE(compared, 6);
}

TEST(Gallery, TheReadmeShowsWhatThereIs) {
    const std::string readme = test_support::read_file(kRoot / "README.md");
    const std::regex link("\\]\\(([^)#:]+)\\)");
    int links = 0;
    for (std::sregex_iterator at(readme.begin(), readme.end(), link), end; at != end; ++at, ++links) {
        EXPECT_TRUE(fs::exists(kRoot / (*at)[1].str())) << (*at)[1];
    }
    EXPECT_GE(links, 10);
}

}  // namespace
