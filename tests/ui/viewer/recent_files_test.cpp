// The files that were opened last.
#include "ui/viewer/recent_files.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace ui {
namespace {

using Paths = std::vector<std::string>;

Paths of(const RecentFiles& recent) {
    return {recent.paths().begin(), recent.paths().end()};
}

TEST(RecentFiles, TheLastComesFirstAndIsKept) {
    const test_support::TemporaryFolder folder;
    const std::string list = folder.path("state/csgscope/recent");
    const std::string a = folder.write("a.scad", ""), b = folder.write("b.scad", "");
    RecentFiles recent(list);
    EXPECT_TRUE(recent.paths().empty());
    recent.add(a);
    recent.add(b);
    recent.add(a);
    recent.add(folder.path("missing.scad"));
    EXPECT_EQ(of(recent), (Paths{a, b}));
    RecentFiles later(list);
    EXPECT_EQ(of(later), (Paths{a, b}));
    std::filesystem::remove(a);
    EXPECT_EQ(of(RecentFiles(list)), Paths{b}) << "what is gone is not offered";
}

TEST(RecentFiles, WindowsAtOneTimeKeepEachOthersFiles) {
    const test_support::TemporaryFolder folder;
    const std::string a = folder.write("a.scad", ""), b = folder.write("b.scad", "");
    RecentFiles first(folder.path("recent")), second(folder.path("recent"));
    first.add(a);
    second.add(b);
    EXPECT_EQ(of(RecentFiles(folder.path("recent"))), (Paths{b, a}));
}

TEST(RecentFiles, AreBounded) {
    const test_support::TemporaryFolder folder;
    RecentFiles recent(folder.path("recent"));
    for (int i = 0; i < 25; ++i) {
        recent.add(folder.write(std::to_string(i) + ".scad", ""));
    }
    EXPECT_EQ(recent.paths().size(), RecentFiles::kMost);
    EXPECT_EQ(recent.paths().front(), folder.path("24.scad"));
}

TEST(RecentFiles, WithoutAPlaceTheyAreOfThisRun) {
    const test_support::TemporaryFolder folder;
    const std::string a = folder.write("a.scad", "");
    RecentFiles nowhere{std::filesystem::path()};
    nowhere.add(a);
    EXPECT_EQ(of(nowhere), Paths{a});
    RecentFiles unwritable("/proc/csgscope/recent");
    unwritable.add(a);
    EXPECT_EQ(of(unwritable), Paths{a});
}

}  // namespace
}  // namespace ui
