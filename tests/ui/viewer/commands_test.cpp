// Keys and actions.
#include "ui/viewer/commands.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "ui/viewer/camera_control.h"
#include "ui/viewer/keys.h"
#include "ui/viewer/session.h"

namespace ui {
namespace {

TEST(Commands, EveryActionIsListedOnceAndWithoutSharedKeys) {
    std::set<Action> seen;
    std::set<std::pair<int, int>> chords;
    for (const ActionInfo& each : actions()) {
        EXPECT_TRUE(seen.insert(each.action).second) << each.label;
        for (const Chord& chord : each.keys) {
            if (chord.key != 0) {
                EXPECT_TRUE(chords.insert({chord.key, chord.modifiers}).second) << text(chord);
                EXPECT_EQ(Keys().action_of(chord), each.action) << text(chord);
            }
        }
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(Action::Close) + 1) << "Close is the last action";
}

TEST(Commands, NoKeyIsNoAction) {
    EXPECT_EQ(Keys().action_of({}), std::nullopt);
    EXPECT_EQ(Keys().action_of({GLFW_KEY_F20, 0}), std::nullopt);
    EXPECT_EQ(Keys().action_of({GLFW_KEY_V, GLFW_MOD_ALT}), std::nullopt);
}

TEST(Commands, StandardViewsHaveOpenscadsKeys) {
    // Towards the eye.
    const std::map<std::string, std::pair<int, glm::dvec3>> expected{
        {"Top", {4, {0, 0, 1}}},   {"Bottom", {5, {0, 0, -1}}}, {"Left", {6, {-1, 0, 0}}},
        {"Right", {7, {1, 0, 0}}}, {"Front", {8, {0, -1, 0}}},  {"Back", {9, {0, 1, 0}}}};
    std::size_t found = 0;
    for (const ActionInfo& each : actions()) {
        EXPECT_EQ(looks_from(each.action), each.from);
        const auto view = expected.find(each.label);
        if (view != expected.end()) {
            ASSERT_TRUE(each.from.has_value()) << each.label;
            base::Camera camera;
            camera.rotation = *each.from;
            EXPECT_EQ(glm::transpose(glm::dmat3(camera.eye_from_world())) * glm::dvec3(0, 0, 1), view->second.second)
                << each.label;
            EXPECT_EQ(each.keys[0], (Chord{GLFW_KEY_0 + view->second.first, GLFW_MOD_CONTROL})) << each.label;
            ++found;
        }
    }
    EXPECT_EQ(found, expected.size());
    EXPECT_EQ(looks_from(Action::Diagonal), base::Camera{}.rotation);
    EXPECT_EQ(looks_from(Action::ViewAll), std::nullopt);
    EXPECT_EQ(looks_from(Action::Reload), std::nullopt);
}

TEST(Commands, KeysAreNamedAsOnTheKeyboard) {
    EXPECT_EQ(text(Chord{GLFW_KEY_V, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT}), "Ctrl+Shift+V");
    EXPECT_EQ(text(Chord{GLFW_KEY_F5, 0}), "F5");
    EXPECT_EQ(text(Chord{GLFW_KEY_HOME, 0}), "Home");
    EXPECT_EQ(text(Chord{GLFW_KEY_EQUAL, GLFW_MOD_SHIFT}), "+");
    EXPECT_EQ(text(Chord{}), "");
}

}  // namespace
}  // namespace ui
