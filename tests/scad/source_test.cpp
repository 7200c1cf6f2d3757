// Reading source texts from disk.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "csg/scad/source.h"

namespace {

namespace fs = std::filesystem;
using csg::scad::read_source_file;

class ReadSource : public testing::Test {
  protected:
    ReadSource() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~ReadSource() override { fs::remove_all(folder_); }
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    static std::string error(const std::string& path, bool missing = false) {
        const auto result = read_source_file(path);
        const auto* const error = std::get_if<csg::scad::ReadError>(&result);
        EXPECT_TRUE(error != nullptr && error->missing == missing) << path;
        const std::string text = error == nullptr ? "" : error->text;
        return text.substr(std::min(text.size(), text.find(path) + path.size()));
    }

    const fs::path folder_ = fs::path(testing::TempDir()) / "csgscope_read_source";
};

TEST_F(ReadSource, AllBytes) {
    for (const std::size_t size : {0U, 1U, 4095U, 100'000U, 1'234'567U}) {
        std::string text;
        for (std::size_t i = 0; i < size; ++i) {
            text += static_cast<char>(i * i / 7);
        }
        std::ofstream(path("a.scad"), std::ios::binary) << text;
        const auto result = read_source_file(path("a.scad"));
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
    std::ofstream(path("file")) << "1";
    EXPECT_EQ(error(path("file") + "/a.scad", true), ": no such file");
    EXPECT_EQ(error(folder_.string()), ": it is a directory");
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);  // Nobody writes into it: reading would wait for ever.
    EXPECT_EQ(error(path("pipe")), ": it is not a regular file");
    fs::create_symlink("loop", path("loop"));
    EXPECT_EQ(error(path("loop")), ": Too many levels of symbolic links");
}

TEST_F(ReadSource, LargeFilesAreRefused) {
    std::ofstream(path("large.scad")) << "1";
    fs::resize_file(path("large.scad"), csg::scad::kMaxSourceBytes + 1);
    EXPECT_EQ(error(path("large.scad")), ": it is larger than 64 MiB");
    fs::resize_file(path("large.scad"), std::uintmax_t{1} << 40);
    EXPECT_EQ(error(path("large.scad")), ": it is larger than 64 MiB");
}

}  // namespace
