// Paths as texts, held against std::filesystem's.
#include "csg/scad/source/paths.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <filesystem>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using csg::scad::folder_of_path;
using csg::scad::normal_path;
using csg::scad::path_in;

/// Paths of a few pieces, among them all that mean something.
std::string any_path() {
    std::string path;
    for (const std::string& piece : *rc::gen::container<std::vector<std::string>>(
             rc::gen::elementOf(std::vector<std::string>{"/", "/", "/", ".", "..", "a", "b.scad", ".c", "..."}))) {
        path += piece;
    }
    return path;
}

TEST(Paths, AreNormalAsFilesystemHasThem) {
    EXPECT_TRUE(rc::check("normal_path", [] {
        const std::string path = any_path();
        RC_ASSERT(normal_path(path) == fs::path(path).lexically_normal().string());
    }));
    for (const char* const path : {"", "a", "/", "/..", "/../a", "../a", "../../a", "a/../../b", "a/b/../../c", "./a",
                                   "a//b", "//a", "a/./b", "a/..", "a/.", "a/", "/a/../../b", ".a/..b/.../c", "a/.b"}) {
        EXPECT_EQ(normal_path(path), fs::path(path).lexically_normal().string()) << path;
    }
}

TEST(Paths, OfAFolder) {
    EXPECT_TRUE(rc::check("path_in", [] {
        const std::string folder = any_path();
        const std::string name = any_path();
        RC_PRE(!folder.starts_with("//") ||
               folder.find_first_not_of('/') != std::string::npos);  // It keeps the slashes.
        RC_ASSERT(normal_path(path_in(folder, name)) == (fs::path(folder) / name).lexically_normal().string());
    }));
    EXPECT_EQ(folder_of_path("a/b/c"), "a/b");
    EXPECT_EQ(folder_of_path("a"), "");
    EXPECT_EQ(folder_of_path("/a"), "/");
}

}  // namespace
