// Depictions and labels in a session: what is looked for once, what follows at once, and what is told of what is wrong.
#include "ui/viewer/dynamics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/support/temporary_folder.h"
#include "ui/pipeline/part_names.h"
#include "ui/viewer/dynamics_panel.h"
#include "ui/viewer/session.h"

namespace ui {
namespace {

using namespace std::chrono_literals;

constexpr const char* kDoor =
    "speed = 1;\n"
    "module door() cube([10, 1, 20]);\n"
    "module frame() translate([-1, 0, 0]) cube([1, 1, 22]);\n"
    "rotate(90 * speed * $t) door();\n"
    "frame();\n";

class DynamicsTest : public testing::Test {
  protected:
    void open(GlyphTexts glyphs = {}, const char* text = kDoor) {
        WindowOptions options;
        options.source.path = folder_.write("door.scad", text);
        options.glyphs = std::move(glyphs);
        session_ = std::make_unique<Session>(options, make_evaluate(), [] {});
    }
    template <typename Condition>
    testing::AssertionResult until(Condition&& condition) {
        for (int i = 0; i < 4000; ++i) {
            now_ += 0.02;
            (void)session_->update(now_);
            if (condition()) {
                return testing::AssertionSuccess();
            }
            std::this_thread::sleep_for(2ms);
        }
        return testing::AssertionFailure() << session_->dynamics().record().error;
    }
    bool rests() const { return !session_->evaluating() && !session_->dynamics().looking_for(); }
    const Model& model() const { return *session_->document().model(); }
    void give(DynamicsCommand command) { ASSERT_TRUE(session_->perform(command)); }
    void depict(std::vector<std::string> depictions) {
        GlyphTexts texts = session_->dynamics().texts();
        texts.depictions = std::move(depictions);
        give(SetGlyphs{texts});
    }
    void select(const std::string& module) {
        const auto& tree = *model().tree;
        for (const csg::LeafInstance& leaf : model().scene.leaves) {
            for (const CallStep& step : steps_to(model(), leaf.occurrence)) {
                if (step.statement != nullptr && step.statement->name == module) {
                    ASSERT_TRUE(session_->perform(SelectCall{leaf.occurrence, {}, module}));
                    return;
                }
            }
        }
        FAIL() << "no " << module << " in " << tree.size() << " nodes";
    }

    test_support::TemporaryFolder folder_;
    std::unique_ptr<Session> session_;
    double now_ = 0;
};

TEST_F(DynamicsTest, GlyphsOfTheCommandLineAreThere) {
    GlyphTexts glyphs;
    glyphs.depictions = {"rotation {door}", "frame {door} (text=\"now\")"};
    glyphs.annotations.labels = {"frame=A frame"};
    open(glyphs);
    EXPECT_TRUE(session_->shown().dynamics);
    ASSERT_TRUE(until([&] { return session_->document().glyphs().of != nullptr && rests(); }));
    EXPECT_EQ(session_->dynamics().record().searches, 1);
    EXPECT_EQ(session_->dynamics().motion()->bodies.size(), 1u);
    EXPECT_EQ(session_->dynamics().record().error, "");
    ASSERT_NE(session_->annotations(), nullptr);
    EXPECT_EQ(session_->annotations()->labels.size(), 1u);
    EXPECT_EQ(session_->annotations()->frames.size(), 1u);
    EXPECT_EQ(parts_named(model().scene, "", "frame").size(), 1u) << "labels tell parts apart";
    EXPECT_GT(model().scene.leaves.size(), 2u) << "an arrow";
}

TEST_F(DynamicsTest, WhatMovesIsLookedForOnce) {
    open();
    ASSERT_TRUE(until([&] { return session_->document().model() != nullptr && rests(); }));
    EXPECT_EQ(session_->dynamics().record().searches, 0) << "nobody asks";
    depict({"rotation {door}"});
    ASSERT_TRUE(until([&] { return session_->document().glyphs().of != nullptr && rests(); }));
    const std::size_t leaves = model().scene.leaves.size();
    // Another expression, another time, another camera and another label: the motion is the same.
    depict({"rotation {door}", "still {door} [1]"});
    ASSERT_TRUE(until([&] { return model().scene.leaves.size() > leaves && rests(); }));
    session_->perform(SetStep{30});
    session_->perform(Action::TurnLeft);
    GlyphTexts texts = session_->dynamics().texts();
    texts.annotations.callouts = true;
    give(SetGlyphs{texts});
    ASSERT_TRUE(until([&] { return rests() && session_->annotations() && session_->annotations()->callouts; }));
    EXPECT_EQ(session_->dynamics().record().searches, 1);
    // A longer time, or another value of the customizer, is another motion.
    depict({"ghost {door} [0,2]"});
    ASSERT_TRUE(
        until([&] { return session_->dynamics().motion() && session_->dynamics().motion()->times.back() == 2; }));
    session_->perform(SetCustomized{"speed", 2.0});
    ASSERT_TRUE(until([&] { return session_->dynamics().record().searches == 3 && rests(); }));
    // Without any the model is as it was.
    give(SetGlyphs{{}});
    ASSERT_TRUE(until([&] { return rests() && model().scene.leaves.size() == 2; }));
    EXPECT_EQ(session_->annotations(), nullptr);
}

TEST_F(DynamicsTest, WhatIsWrongIsToldWhereItIs) {
    std::string rules = folder_.write("rules.txt", "rotation {d*}\npath {door} [1\n");
    GlyphTexts glyphs;
    glyphs.depictions = {"path {door", "rotation {door}", "path {dor}"};
    glyphs.rules_file = rules;
    glyphs.annotations.labels = {"frame", "frme=A frame", "frame=A frame"};
    glyphs.annotations.arrows = {"0,0,0", "0,0,0:1,2,3"};
    open(glyphs);
    ASSERT_TRUE(until([&] { return session_->document().glyphs().of != nullptr && rests(); }));
    const Dynamics::Errors& errors = session_->dynamics().errors();
    EXPECT_EQ(errors.depictions[0], "expected '}'\n  path {door\n            ^");
    EXPECT_EQ(errors.depictions[1], "");
    EXPECT_NE(errors.depictions[2].find("Did you mean \"door\"?"), std::string::npos) << errors.depictions[2];
    EXPECT_NE(errors.rules.find(":2:15: expected ']'"), std::string::npos) << errors.rules;
    EXPECT_EQ(errors.labels[0], "expected PART=TEXT");
    EXPECT_NE(errors.labels[1].find("Did you mean \"frame\"?"), std::string::npos) << errors.labels[1];
    EXPECT_EQ(errors.labels[2], "");
    EXPECT_EQ(errors.arrows[0], "expected two points or more, x,y,z:x,y,z");
    EXPECT_EQ(errors.arrows[1], "");
    ASSERT_NE(session_->annotations(), nullptr);
    EXPECT_EQ(session_->dynamics().options(), (std::vector<std::string>{"--depict", "rotation {door}", "--label",
                                                                        "frame=A frame", "--arrow", "0,0,0:1,2,3"}))
        << "what frames are exported with";
    EXPECT_EQ(session_->annotations()->labels.size(), 1u) << "what is right is drawn";
    EXPECT_EQ(session_->annotations()->arrows.size(), 1u);
}

TEST_F(DynamicsTest, WhatIsSelectedIsDepictedAndLabeled) {
    open();
    ASSERT_TRUE(until([&] { return session_->document().model() != nullptr && rests(); }));
    session_->perform(Action::ToggleDynamics);
    ASSERT_TRUE(until([&] { return session_->dynamics().motion() != nullptr && rests(); })) << "the panel lists it";
    select("frame");
    give(DepictSelected{"path"});
    EXPECT_TRUE(session_->dynamics().texts().depictions.empty()) << "it stands still";
    select("door");
    give(DepictSelected{"rotation"});
    EXPECT_EQ(session_->dynamics().texts().depictions, std::vector<std::string>{"rotation {door}"});
    ASSERT_TRUE(until([&] { return session_->document().glyphs().of != nullptr && rests(); }));
    select("frame");
    give(LabelSelected{"Oak"});
    ASSERT_TRUE(until([&] { return rests() && session_->annotations() != nullptr; })) << "parts come first";
    EXPECT_EQ(session_->dynamics().texts().annotations.labels, std::vector<std::string>{"frame=Oak"});
    select("door");
    give(LabelSelected{""});
    ASSERT_TRUE(until([&] { return rests() && session_->annotations()->labels.size() == 2; }));
    EXPECT_EQ(session_->dynamics().texts().annotations.labels[1], "door=door");
}

TEST_F(DynamicsTest, ASearchIsGivenUp) {
    // A shape that takes long enough to run.
    open({}, "n = [for (i = [0:300000]) i * $t]; translate([n[7], 0, 0]) cube(1);");
    ASSERT_TRUE(until([&] { return session_->document().model() != nullptr && rests(); }));
    depict({"path"});
    ASSERT_TRUE(session_->dynamics().looking_for().has_value());
    give(CancelMotion{});
    EXPECT_FALSE(session_->dynamics().looking_for().has_value());
    session_->perform(Action::Reload);
    ASSERT_TRUE(until([&] { return rests(); }));
    EXPECT_EQ(session_->dynamics().motion(), nullptr) << "it is not begun again by itself";
    give(LookForMotion{});
    EXPECT_TRUE(session_->dynamics().looking_for().has_value());
}

TEST(GlyphTexts, AreOptionsOfTheCommandLine) {
    GlyphTexts texts;
    texts.depictions = {"speak {a} (text='it''s')"};
    texts.rules_file = "r.txt";
    texts.annotations.labels = {"a=A"};
    texts.annotations.callouts = true;
    EXPECT_EQ(options_of(texts),
              "--depict 'speak {a} (text='\\''it'\\'''\\''s'\\'')' --depict-rules 'r.txt' --label 'a=A' --callouts");
    EXPECT_EQ(options_of({}), "");
}

}  // namespace
}  // namespace ui
