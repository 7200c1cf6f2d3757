// What the console keeps of a program's messages.
#include "ui/viewer/message_log.h"

#include <gtest/gtest.h>

namespace ui {
namespace {

using csg::scad::Message;
using csg::scad::Severity;

class Log : public testing::Test {
  protected:
    Log() { sources_.add(csg::scad::SourceFile("/tmp/deep/model.scad", "cube(1);\nfoo(  bar);\n")); }

    csg::scad::SourceSet sources_;
    MessageLog log_;
};

TEST_F(Log, AnErrorHasPlaceSourceLineAndCaret) {
    log_.add(Message{Severity::Error, {0, 2, 7, 2, 10}, "bar is nothing"}, sources_);
    ASSERT_EQ(log_.lines().size(), 3U);
    EXPECT_EQ(log_.lines()[0].kind, LineKind::Error);
    EXPECT_EQ(log_.lines()[0].text, "/tmp/deep/model.scad:2:7: error: bar is nothing");
    EXPECT_EQ(log_.lines()[1].kind, LineKind::Excerpt);
    EXPECT_EQ(log_.lines()[1].text, "foo(  bar);");
    EXPECT_EQ(log_.lines()[2].text.find('^'), 6U);
    EXPECT_EQ(log_.first_error(), "model.scad:2:7: bar is nothing");
    EXPECT_EQ(log_.errors(), 1U);
    EXPECT_EQ(log_.warnings(), 0U);
}

TEST_F(Log, EchoesAreLinesAsOpenscadPrintsThem) {
    log_.add(Message{Severity::Echo, {0, 1, 1, 1, 5}, "1, 2"}, sources_);
    ASSERT_EQ(log_.lines().size(), 1U);
    EXPECT_EQ(log_.lines()[0].kind, LineKind::Echo);
    EXPECT_EQ(log_.lines()[0].text, "ECHO: 1, 2");
}

TEST_F(Log, ADeprecationIsAWarning) {
    log_.add(Message{Severity::Deprecated, {0, 1, 1, 1, 5}, "old"}, sources_);
    log_.add(Message{Severity::Warning, {}, "without place"}, sources_);
    EXPECT_EQ(log_.warnings(), 2U);
    EXPECT_EQ(log_.lines()[0].kind, LineKind::Warning);
    EXPECT_EQ(log_.first_error(), "");
}

TEST_F(Log, TheFirstErrorStays) {
    log_.add(LineKind::Error, "one\nsecond line");
    log_.add(LineKind::Error, "two");
    EXPECT_EQ(log_.first_error(), "one");
    EXPECT_EQ(log_.errors(), 2U);
    EXPECT_EQ(log_.text(), "one\nsecond line\ntwo\n");
}

TEST_F(Log, IsBoundedAndKeepsTheErrorAtTheEnd) {
    for (int i = 0; i < 100'000; ++i) {
        log_.add(Message{Severity::Echo, {}, std::to_string(i)}, sources_);
    }
    log_.add(LineKind::Error, "at the end");
    EXPECT_LE(log_.lines().size(), 20'001U);
    EXPECT_EQ(log_.lines().size() + log_.left_out(), 100'001U);
    EXPECT_EQ(log_.lines().back().text, "at the end");
    EXPECT_NE(log_.text().find(std::to_string(log_.left_out()) + " more"), std::string::npos);
}

TEST_F(Log, ErrorsAreBoundedToo) {
    for (int i = 0; i < 100'000; ++i) {
        log_.add(LineKind::Error, "again");
    }
    EXPECT_EQ(log_.errors(), 100'000U);
    EXPECT_LE(log_.lines().size(), 21'000U);
}

TEST_F(Log, LongLinesAreCutBetweenCharacters) {
    std::string text;
    for (int i = 0; i < 10'000; ++i) {
        text += "ä";
    }
    log_.add(Message{Severity::Echo, {}, text}, sources_);
    const std::string& line = log_.lines()[0].text;
    EXPECT_LT(line.size(), 4100U);
    EXPECT_EQ(line.substr(line.size() - 5), "ä…");
}

}  // namespace
}  // namespace ui
