#include "ui/viewer/save_path.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace ui {
namespace {

TEST(SavePath, IsWhatWasTyped) {
    EXPECT_EQ(save_path("a.png").path, "a.png");
    EXPECT_EQ(save_path("/tmp/b c.PNG").path, "/tmp/b c.PNG");
    EXPECT_EQ(save_path("  a.png ").path, "a.png");
}

TEST(SavePath, GetsASuffixOrIsRefused) {
    EXPECT_EQ(save_path("part").path, "part.png");
    EXPECT_EQ(save_path("v1.2/part").path, "v1.2/part.png");
    EXPECT_EQ(save_path("part.jpg").error, "Pictures are saved as PNG: part.png");
    EXPECT_NE(save_path("").error, "");
    EXPECT_NE(save_path("  ").error, "");
    EXPECT_NE(save_path("folder/").error, "");
    EXPECT_NE(save_path("~").error, "");
}

TEST(SavePath, BeginsAtHome) {
    const char* const home = std::getenv("HOME");
    const std::string before = home != nullptr ? home : "";
    setenv("HOME", "/home/somebody", 1);
    EXPECT_EQ(save_path("~/a.png").path, "/home/somebody/a.png");
    EXPECT_EQ(save_path("~other/a.png").path, "~other/a.png");
    setenv("HOME", before.c_str(), 1);
}

}  // namespace
}  // namespace ui
