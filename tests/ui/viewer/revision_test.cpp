// From a file to a model, with all that was read on the way.
#include "ui/viewer/revision.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/support/temporary_folder.h"

namespace ui {
namespace {

class RevisionTest : public testing::Test {
  protected:
    Revision make(const Source& source, const std::stop_token& stop = {}) { return evaluate_(source, {}, stop); }
    Revision make(const std::string& text) {
        return make(Source{folder_.write("main.scad", text), {}, {}, true, false});
    }

    test_support::TemporaryFolder folder_;
    Evaluate evaluate_ = make_evaluate();
};

TEST_F(RevisionTest, AModelAndItsEchoes) {
    const Revision revision = make("echo(1); cube(10);");
    ASSERT_NE(revision.model, nullptr);
    EXPECT_EQ(revision.model->box.hi, glm::dvec3(10));
    ASSERT_EQ(revision.messages.lines().size(), 1U);
    EXPECT_EQ(revision.messages.lines()[0].text, "ECHO: 1");
}

TEST_F(RevisionTest, AnErrorIsLocatedAndThereIsNoModel) {
    const Revision revision = make("cube(10);\ncube([1, 2;\n");
    EXPECT_EQ(revision.model, nullptr);
    EXPECT_EQ(revision.messages.first_error().substr(0, 12), "main.scad:2:");
    EXPECT_EQ(revision.files.count(folder_.path("main.scad")), 1U) << "it is to be watched all the same";
}

TEST_F(RevisionTest, WhatWasReadAndWhatWasMissingIsToBeWatched) {
    folder_.write("part.scad", "a = 1;");
    const Revision revision = make("include <part.scad>\ninclude <missing.scad>\ncube(a);");
    for (const char* name : {"main.scad", "part.scad"}) {
        ASSERT_EQ(revision.files.count(folder_.path(name)), 1U) << name;
        EXPECT_EQ(revision.files.at(folder_.path(name)), csg::scad::disk_state(folder_.path(name))) << name;
    }
    ASSERT_EQ(revision.files.count(folder_.path("missing.scad")), 1U);
    EXPECT_FALSE(revision.files.at(folder_.path("missing.scad")).exists);
}

TEST_F(RevisionTest, TextThatIsGivenIsNotWatched) {
    const Revision revision = make(Source{"-", "cube(x);", {"x=4"}, true, false});
    ASSERT_NE(revision.model, nullptr);
    EXPECT_EQ(revision.model->box.hi, glm::dvec3(4));
    for (const auto& [path, stamp] : revision.files) {
        ADD_FAILURE() << path;
    }
}

TEST_F(RevisionTest, AHardWarningIsAnError) {
    const std::string path = folder_.write("main.scad", "cube(unknown_thing);");
    EXPECT_NE(make(Source{path, {}, {}, true, false}).model, nullptr);
    const Revision hard = make(Source{path, {}, {}, true, true});
    EXPECT_EQ(hard.model, nullptr);
    EXPECT_GE(hard.messages.errors(), 1U);
    EXPECT_EQ(hard.messages.warnings(), 1U);
}

TEST_F(RevisionTest, AStoppedEvaluationEndsSoonWithoutAModel) {
    const std::string path = folder_.write(
        "main.scad", "function f(n, s = 0) = n == 0 ? s : f(n - 1, s + 1);\nfor (i = [0 : 9999]) echo(f(900000));");
    std::stop_source stop;
    const auto begin = std::chrono::steady_clock::now();
    std::jthread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        stop.request_stop();
    });
    const Revision revision = make(Source{path, {}, {}, true, false}, stop.get_token());
    EXPECT_EQ(revision.model, nullptr);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST_F(RevisionTest, AMissingFileIsAnErrorAndIsWatched) {
    const Revision revision = make(Source{folder_.path("nothing.scad"), {}, {}, true, false});
    EXPECT_EQ(revision.model, nullptr);
    EXPECT_EQ(revision.messages.errors(), 1U);
    EXPECT_EQ(revision.files.count(folder_.path("nothing.scad")), 1U);
}

TEST_F(RevisionTest, CallsAreHiddenAndShownAlone) {
    Source source{folder_.write("main.scad",
                                "difference() {\n  cube(10);\n  translate([5, 5, 5]) cube(20);\n}\n"
                                "translate([100, 0, 0]) sphere(3);\n"),
                  {},
                  {},
                  true,
                  false};
    const std::string file = source.path;
    source.hidden = {{"translate", file, 5, 1}, {"gone", file, 99, 1}};
    EXPECT_EQ(make(source).model->box.hi, glm::dvec3(10));
    source.hidden = {{"cube", file, 2, 3}};
    EXPECT_GT(make(source).model->box.lo.x, 90) << "a difference of nothing is nothing";
    source.hidden.clear();
    source.alone = CallAt{"cube", file, 3, 24};
    const Revision cutter = make(source);
    EXPECT_EQ(cutter.model->box.lo, glm::dvec3(5));
    EXPECT_EQ(cutter.model->box.hi, glm::dvec3(25)) << "a cutter, where it cuts";
    source.alone.reset();
    source.time = 0.25;
    folder_.write("main.scad", "cube(100 * $t);");
    EXPECT_EQ(make(source).model->box.hi, glm::dvec3(25));
}

}  // namespace
}  // namespace ui
