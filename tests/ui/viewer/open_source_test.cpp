// What the window opens, and as what.
#include "ui/viewer/open_source.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace ui {
namespace {

TEST(OpenSource, ProgramsAreReadAndMeshesImported) {
    Source before;
    before.path = "other.scad";
    before.definitions = {"x=1"};
    before.customized = {"y=2"};
    before.preview = false;
    const Source program = opened("/models/box.scad", before);
    EXPECT_EQ(program.path, "/models/box.scad");
    EXPECT_EQ(program.followed(), program.path);
    EXPECT_FALSE(program.text.has_value());
    EXPECT_TRUE(program.definitions.empty() && program.customized.empty()) << "these were of another file";
    EXPECT_FALSE(program.preview);
    const Source mesh = opened("/models/a \"b\".STL", before);
    EXPECT_EQ(mesh.text, "import(\"/models/a \\\"b\\\".STL\");\n");
    EXPECT_EQ(mesh.followed(), "/models/a \"b\".STL");
    EXPECT_TRUE(std::filesystem::path(opened("box.scad", before).path).is_absolute());
}

TEST(OpenSource, BySuffix) {
    for (const char* const good : {"a.scad", "a.SCAD", "a.csg", "a.stl", "a.3mf", "a.svg", "a.dxf", "a.amf", "a.obj"}) {
        EXPECT_TRUE(can_open(good)) << good;
    }
    for (const char* const bad : {"a.png", "a", "scad", "a.scad.bak", ""}) {
        EXPECT_FALSE(can_open(bad)) << bad;
    }
}

TEST(OpenSource, FoldersComeFirst) {
    const test_support::TemporaryFolder folder;
    for (const char* const name : {"b.scad", "a.stl", "notes.txt", ".hidden.scad"}) {
        folder.write(name, "");
    }
    std::filesystem::create_directory(folder.path("z"));
    std::filesystem::create_directory(folder.path(".git"));
    EXPECT_EQ(entries_of(folder.path("")),
              (std::vector<FolderEntry>{{"z", true}, {"a.stl", false}, {"b.scad", false}}));
    EXPECT_TRUE(entries_of(folder.path("missing")).empty());
}

}  // namespace
}  // namespace ui
