// Texts that stay as long as their files do not change.
#include "csg/scad/source/source_store.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>

#include "tests/support/temporary_folder.h"

namespace {

using csg::scad::read_source_file;
using csg::scad::ReadError;
using csg::scad::ReadResult;
using csg::scad::SharedSource;
using csg::scad::SourceStore;

class Store : public testing::Test {
  protected:
    SharedSource read() { return std::get<SharedSource>(store_.read(path_, read_source_file).result); }
    /// As if it had last been written in 2001.
    void make_old() const {
        const std::array<timespec, 2> times{timespec{1'000'000'000, 0}, timespec{1'000'000'000, 0}};
        ASSERT_EQ(utimensat(AT_FDCWD, path_.c_str(), times.data(), 0), 0);
    }

    test_support::TemporaryFolder folder_;
    std::string path_ = folder_.write("a.scad", "one");
    SourceStore store_;
};

TEST_F(Store, ATextThatIsTheSameIsTheSameObject) {
    const SharedSource first = read();
    EXPECT_EQ(first->text(), "one");
    EXPECT_EQ(read(), first);
    folder_.replace("a.scad", "one");  // Another file with the same text.
    EXPECT_EQ(read(), first);
    folder_.write("a.scad", "\xEF\xBB\xBFone");
    EXPECT_NE(read(), first) << "offsets in the file are others";
    EXPECT_EQ(read()->mark_bytes(), 3U);
}

TEST_F(Store, AChangeIsSeenThoughSizeAndTimesAreTheSame) {
    make_old();
    EXPECT_EQ(read()->text(), "one");
    folder_.write("a.scad", "two");
    make_old();
    EXPECT_EQ(read()->text(), "two");
    folder_.write("a.scad", "six");  // Within the same tick of the clock, perhaps.
    EXPECT_EQ(read()->text(), "six");
}

TEST_F(Store, FilesComeAndGo) {
    EXPECT_EQ(read()->text(), "one");
    folder_.remove("a.scad");
    const SourceStore::Answer gone = store_.read(path_, read_source_file);
    EXPECT_TRUE(std::get<ReadError>(gone.result).missing);
    EXPECT_FALSE(gone.state->exists);
    EXPECT_TRUE(same_source(gone.result, store_.read(path_, read_source_file).result));
    folder_.write("a.scad", "one");
    EXPECT_EQ(read()->text(), "one");
}

TEST_F(Store, OtherReadersAreAskedEveryTime) {
    int times = 0;
    const auto reader = [&](const std::string&) -> ReadResult { return std::to_string(++times / 2); };
    const auto text = [&] { return std::get<SharedSource>(store_.read(path_, reader).result); };
    EXPECT_EQ(text()->text(), "0");
    const SharedSource one = text();
    EXPECT_EQ(text(), one);
    EXPECT_NE(text(), one);
    EXPECT_EQ(times, 4);
    EXPECT_FALSE(store_.read(path_, reader).state.has_value());
}

TEST_F(Store, WhatNobodyAsksForIsLetGo) {
    const std::weak_ptr<const csg::scad::SourceFile> file = read();
    for (std::uint32_t i = 0; i < SourceStore::kKept; ++i) {
        store_.trim();
    }
    EXPECT_FALSE(file.expired());
    store_.trim();
    EXPECT_TRUE(file.expired());
}

}  // namespace
