#include "base/image.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>

#include "base/decode_png.h"
#include "base/file.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

class ImageTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_;
};

TEST_F(ImageTest, PngGivesBackWhatWasWritten) {
    for (const int alpha : {255, 100}) {
        base::Image image{9, 5, {}};
        for (int i = 0; i < 9 * 5; ++i) {
            for (const int v : {i * 5, 255 - i, i * i, alpha}) {
                image.rgba.push_back(static_cast<std::uint8_t>(v & 255));
            }
        }
        base::write_file(folder_ / "a.png", base::encode_png(image));
        const base::Image back = base::read_png(folder_ / "a.png");
        EXPECT_EQ(base::decode_png(test_support::read_file(folder_ / "a.png"), "a").rgba, back.rgba);
        EXPECT_EQ(back.width, 9);
        EXPECT_EQ(back.height, 5);
        EXPECT_EQ(back.rgba, image.rgba);
    }
}

TEST_F(ImageTest, PngTellsTheResolutionWhereItIsSaid) {
    const base::Image image{1, 1, {0, 0, 0, 255}};
    EXPECT_EQ(base::encode_png(image).find("pHYs"), std::string::npos);
    const std::string png = base::encode_png(image, {}, 300);
    const std::size_t at = png.find("pHYs");
    ASSERT_NE(at, std::string::npos);
    // 300 / 25.4 mm are 11811 to the meter, in either direction; 1: the unit is the meter.
    EXPECT_EQ(png.substr(at + 4, 9), std::string("\0\0\x2e\x23\0\0\x2e\x23\1", 9));
}

TEST_F(ImageTest, PngGivesBackWhatIsShadedAndWhatIsDrawn) {
    // Rows that resemble each other are told by their differences, others as they are.
    for (const bool shaded : {true, false}) {
        base::Image image{90, 70, {}};
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const int value = shaded ? x * x + 3 * y : (x / 20 + y / 9) % 2 * 200;
                for (int k = 0; k < 3; ++k) {
                    image.rgba.push_back(static_cast<std::uint8_t>(value + k));
                }
                image.rgba.push_back(255);
            }
        }
        base::write_file(folder_ / "a.png", base::encode_png(image));
        EXPECT_EQ(base::read_png(folder_ / "a.png").rgba, image.rgba);
        EXPECT_LT(std::filesystem::file_size(folder_ / "a.png"), 700u) << shaded;
    }
}

TEST_F(ImageTest, WritingLeavesNothingElseBehind) {
    base::write_file(folder_ / "a", "first");
    base::write_file(folder_ / "a", "second");
    std::ifstream in(folder_ / "a");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "second");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(ImageTest, AMissingFolderIsNamed) {
    try {
        base::write_file(folder_ / "no" / "a", "x");
        FAIL() << "it was written";
    } catch (const std::runtime_error& e) {
        EXPECT_NE(std::string(e.what()).find("/no/a"), std::string::npos) << e.what();
    }
}

TEST_F(ImageTest, WhatIsNotFinishedIsNotThere) {
    base::write_file(folder_ / "a", "first");
    {
        base::FileWriter writer(folder_ / "a");
        writer.write("sec");
    }
    EXPECT_EQ(test_support::read_file(folder_ / "a"), "first");
    {
        base::FileWriter writer(folder_ / "a");
        writer.write("sec");
        writer.write("ond");
        EXPECT_EQ(test_support::read_file(folder_ / "a"), "first");
        writer.finish();
    }
    EXPECT_EQ(test_support::read_file(folder_ / "a"), "second");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

/// Of a text of 2 GB that is not there.
TEST_F(ImageTest, WhatAPngClaimsTakesNoMemory) {
    const std::string head = base::encode_png({1, 1, {0, 0, 0, 255}}).substr(0, 33);  // Signature and IHDR.
    const auto peak = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss;  // KiB
    };
    const long before = peak();
    for (const std::string kind : {"tEXt", "zTXt", "iTXt", "iCCP", "sPLT", "eXIf"}) {
        base::write_file(folder_ / "a.png", head + "\x7f\xff\xff\xff" + kind + std::string("a\0b", 3));
        EXPECT_THROW((void)base::read_png(folder_ / "a.png"), std::runtime_error) << kind;
    }
    EXPECT_LT(peak() - before, 100 * 1024);
}

TEST_F(ImageTest, NotAPngIsAnError) {
    base::write_file(folder_ / "a.png", "not a picture");
    EXPECT_THROW((void)base::read_png(folder_ / "a.png"), std::runtime_error);
    EXPECT_THROW((void)base::read_png(folder_ / "none.png"), std::runtime_error);
}

}  // namespace
