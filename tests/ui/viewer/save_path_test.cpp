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

TEST(ExportPath, TheSuffixDecides) {
    EXPECT_EQ(export_path("box").path, "box.stl");
    EXPECT_EQ(export_path("a/box.3MF").path, "a/box.3MF");
    EXPECT_EQ(export_path(" box.svg ").path, "box.svg");
    EXPECT_NE(export_path("box.step").error.find("box.stl"), std::string::npos);
    EXPECT_NE(export_path("").error, "");
    EXPECT_NE(export_path("folder/").error, "");
}

}  // namespace
}  // namespace ui
