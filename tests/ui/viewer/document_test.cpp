// The last good model is kept, and it is said that it is not the newest.
#include "ui/viewer/document.h"

#include <gtest/gtest.h>

#include "tests/ui/viewer/small_model.h"

namespace ui {
namespace {

class DocumentTest : public testing::Test {
  protected:
    Document document_{Source{"/some/where/model.scad", {}, {}, true, false}};
};

TEST_F(DocumentTest, BeginsWithNothing) {
    EXPECT_EQ(document_.state(), DocumentState::Evaluating);
    EXPECT_EQ(document_.model(), nullptr);
    EXPECT_EQ(document_.trouble(), "");
    EXPECT_EQ(document_.file_name(), "model.scad");
}

TEST_F(DocumentTest, AGoodRevisionIsShown) {
    Revision revision = good_revision();
    const auto model = revision.model;
    document_.receive(std::move(revision));
    EXPECT_EQ(document_.state(), DocumentState::Good);
    EXPECT_EQ(document_.model(), model);
    EXPECT_EQ(document_.trouble(), "");
}

TEST_F(DocumentTest, AnErrorKeepsTheLastGoodModelAndSaysSo) {
    document_.receive(good_revision());
    const auto model = document_.model();
    document_.receive(failed_revision());
    EXPECT_EQ(document_.state(), DocumentState::Failed);
    EXPECT_EQ(document_.model(), model);
    EXPECT_EQ(document_.messages().errors(), 1U);
    EXPECT_NE(document_.trouble().find("model.scad:3:5: it is wrong"), std::string::npos);
    EXPECT_NE(document_.trouble().find("last good model"), std::string::npos);

    document_.receive(good_revision());
    EXPECT_EQ(document_.state(), DocumentState::Good);
    EXPECT_NE(document_.model(), model);
    EXPECT_EQ(document_.messages().errors(), 0U);
}

TEST_F(DocumentTest, AnErrorAtFirstShowsNothing) {
    document_.receive(failed_revision());
    EXPECT_EQ(document_.state(), DocumentState::Failed);
    EXPECT_EQ(document_.model(), nullptr);
    EXPECT_NE(document_.trouble().find("nothing to show"), std::string::npos);
}

TEST_F(DocumentTest, ClearingTheConsoleKeepsTheBanner) {
    document_.receive(failed_revision());
    document_.clear_messages();
    EXPECT_TRUE(document_.messages().lines().empty());
    EXPECT_NE(document_.trouble().find("it is wrong"), std::string::npos);
}

TEST_F(DocumentTest, AFileThatIsGoneIsSaidAndTheModelKept) {
    document_.receive(good_revision());
    document_.set_gone(true);
    EXPECT_EQ(document_.state(), DocumentState::Gone);
    EXPECT_NE(document_.model(), nullptr);
    EXPECT_NE(document_.trouble().find("model.scad is gone"), std::string::npos);
    document_.set_gone(false);
    EXPECT_EQ(document_.state(), DocumentState::Good);
}

TEST_F(DocumentTest, AnEmptyModelIsGood) {
    document_.receive(good_revision(empty_model()));
    EXPECT_EQ(document_.state(), DocumentState::Good);
    EXPECT_TRUE(document_.model()->empty());
}

}  // namespace
}  // namespace ui
