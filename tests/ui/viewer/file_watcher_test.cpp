// Files change in many ways; the watcher sees them all, and each once.
#include "ui/viewer/file_watcher.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace ui {
namespace {

class Watcher : public testing::Test {
  protected:
    Watcher() : main_(folder_.write("main.scad", "cube(1);")), part_(folder_.write("part.scad", "a = 1;")) {
        watcher_ = FileWatcher(main_);
        watcher_.watch({{main_, csg::scad::disk_state(main_)}, {part_, csg::scad::disk_state(part_)}});
    }

    /// How often a change is told while time passes.
    int changes() {
        int count = 0;
        for (int i = 0; i < 20; ++i) {
            now_ += 0.05;
            count += watcher_.poll(now_) ? 1 : 0;
        }
        return count;
    }

    test_support::TemporaryFolder folder_;
    std::string main_, part_;
    FileWatcher watcher_;
    double now_ = 100;
};

TEST_F(Watcher, NothingHappensNothingIsTold) {
    EXPECT_EQ(changes(), 0);
    EXPECT_FALSE(watcher_.main_file_gone());
}

TEST_F(Watcher, WritingInPlace) {
    folder_.write("main.scad", "cube(22);");
    EXPECT_EQ(changes(), 1);
    EXPECT_EQ(changes(), 0);
}

TEST_F(Watcher, SavedAgainAndAgainItIsReadAllTheSame) {
    int told = 0;
    for (int i = 0; i < 60; ++i) {
        folder_.write("main.scad", "cube(" + std::string(static_cast<std::size_t>(i) + 1, '1') + ");");
        now_ += 0.08;
        told += watcher_.poll(now_) ? 1 : 0;
    }
    EXPECT_GE(told, 5) << "in 4.8 seconds";
    EXPECT_LE(told, 12) << "and not at each";
    EXPECT_EQ(changes(), 1) << "the last of them";
}

TEST_F(Watcher, RenamingANewFileOverTheOldOfTheSameSizeAndTime) {
    const auto time = std::filesystem::last_write_time(main_);
    folder_.write("other", "cube(2);");
    std::filesystem::last_write_time(folder_.path("other"), time);
    std::filesystem::rename(folder_.path("other"), main_);
    EXPECT_EQ(changes(), 1);
    EXPECT_EQ(changes(), 0);
}

TEST_F(Watcher, AnIncludedFile) {
    folder_.replace("part.scad", "a = 2;");
    EXPECT_EQ(changes(), 1);
}

TEST_F(Watcher, AnIncludedFileThatGoesAndComesBack) {
    folder_.remove("part.scad");
    EXPECT_EQ(changes(), 1);
    EXPECT_FALSE(watcher_.main_file_gone());
    folder_.write("part.scad", "a = 1;");
    EXPECT_EQ(changes(), 1);
}

TEST_F(Watcher, AFileThatWasLookedForInVainAndIsMade) {
    const std::string later = folder_.path("later.scad");
    watcher_.watch({{main_, csg::scad::disk_state(main_)}, {later, csg::scad::disk_state(later)}});
    EXPECT_EQ(changes(), 0);
    folder_.write("later.scad", "b = 1;");
    EXPECT_EQ(changes(), 1);
}

TEST_F(Watcher, TheMainFileGoesAndComesBack) {
    folder_.remove("main.scad");
    EXPECT_EQ(changes(), 0);
    EXPECT_TRUE(watcher_.main_file_gone());
    folder_.write("main.scad", "cube(1);");
    EXPECT_EQ(changes(), 1);
    EXPECT_FALSE(watcher_.main_file_gone());
}

TEST_F(Watcher, AShortGapIsNotGone) {
    folder_.remove("main.scad");
    EXPECT_FALSE(watcher_.poll(now_ += 0.05));
    EXPECT_FALSE(watcher_.poll(now_ += 0.05));
    EXPECT_FALSE(watcher_.main_file_gone());
    folder_.write("main.scad", "cube(2);");
    EXPECT_EQ(changes(), 1);
}

TEST_F(Watcher, WaitsUntilAFileIsWritten) {
    std::string text = "cube(1);";
    for (int i = 0; i < 10; ++i) {
        text += " cube(2);";
        folder_.write("main.scad", text);
        EXPECT_FALSE(watcher_.poll(now_ += 0.05)) << "while it is written";
    }
    EXPECT_EQ(changes(), 1);
}

TEST_F(Watcher, AChangeBetweenReadingAndWatchingIsNotMissed) {
    const DiskState read = csg::scad::disk_state(main_);
    folder_.write("main.scad", "sphere(17);");
    watcher_.watch({{main_, read}});
    EXPECT_EQ(changes(), 1);
}

TEST_F(Watcher, TheMainFileIsWatchedEvenIfNotNamed) {
    watcher_.watch({});
    folder_.write("main.scad", "cube(333);");
    EXPECT_EQ(changes(), 1);
}

TEST(DiskState, OfWhatIsNotThere) {
    EXPECT_FALSE(csg::scad::disk_state("/nowhere/at/all.scad").exists);
    EXPECT_EQ(csg::scad::disk_state(""), DiskState{});
}

}  // namespace
}  // namespace ui
