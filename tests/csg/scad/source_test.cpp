// Reading source texts from disk.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "csg/scad/source/source.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using csg::scad::read_source_file;

class ReadSource : public testing::Test {
  protected:
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }
    static std::string error(const std::string& path, bool missing = false) {
        const auto result = read_source_file(path);
        const auto* const error = std::get_if<csg::scad::ReadError>(&result);
        EXPECT_TRUE(error != nullptr && error->missing == missing) << path;
        const std::string text = error == nullptr ? "" : error->text;
        return text.substr(std::min(text.size(), text.find(path) + path.size()));
    }

    const test_support::TemporaryFolder folder_;
};

TEST_F(ReadSource, AllBytes) {
    for (const std::size_t size : {0U, 1U, 4095U, 100'000U, 1'234'567U}) {
        std::string text;
        for (std::size_t i = 0; i < size; ++i) {
            text += static_cast<char>(i * i / 7);
        }
        const auto result = read_source_file(folder_.write("a.scad", text));
        ASSERT_TRUE(std::holds_alternative<std::string>(result));
        EXPECT_TRUE(std::get<std::string>(result) == text) << size;
    }
}

/// Of files in /proc the size is told only by reading them.
TEST_F(ReadSource, FilesThatDoNotKnowTheirSize) {
    const auto result = read_source_file("/proc/self/status");
    ASSERT_TRUE(std::holds_alternative<std::string>(result));
    EXPECT_NE(std::get<std::string>(result).find("VmPeak"), std::string::npos);
}

TEST_F(ReadSource, WhatIsNoFileSaysSo) {
    EXPECT_EQ(error(path("none.scad"), true), ": no such file");
    EXPECT_EQ(error(folder_.write("file", "1") + "/a.scad", true), ": no such file");
    EXPECT_EQ(error(folder_.path(".")), ": it is a directory");
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);  // Nobody writes into it: reading would wait for ever.
    EXPECT_EQ(error(path("pipe")), ": it is not a regular file");
    fs::create_symlink("loop", path("loop"));
    EXPECT_EQ(error(path("loop")), ": Too many levels of symbolic links");
}

TEST_F(ReadSource, LargeFilesAreRefused) {
    folder_.write("large.scad", "1");
    fs::resize_file(path("large.scad"), csg::scad::kMaxSourceBytes + 1);
    EXPECT_EQ(error(path("large.scad")), ": it is larger than 64 MiB");
    fs::resize_file(path("large.scad"), std::uintmax_t{1} << 40);
    EXPECT_EQ(error(path("large.scad")), ": it is larger than 64 MiB");
}

}  // namespace
