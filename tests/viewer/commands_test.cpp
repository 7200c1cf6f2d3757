// Keys and actions.
#include "ui/viewer/commands.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <set>

#include "ui/viewer/camera_control.h"
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
                EXPECT_EQ(action_of(chord), each.action) << text(chord);
            }
        }
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(Action::Close) + 1) << "Close is the last action";
}

TEST(Commands, NoKeyIsNoAction) {
    EXPECT_EQ(action_of({}), std::nullopt);
    EXPECT_EQ(action_of({GLFW_KEY_F20, 0}), std::nullopt);
    EXPECT_EQ(action_of({GLFW_KEY_V, GLFW_MOD_ALT}), std::nullopt);
}

TEST(Commands, StandardViewsHaveOpenscadsKeys) {
    for (const ActionInfo& each : actions()) {
        const StandardView* view = standard_view(each.action);
        if (view != nullptr) {
            EXPECT_STREQ(view->name, each.label);
            EXPECT_EQ(each.keys[0], (Chord{GLFW_KEY_0 + view->key, GLFW_MOD_CONTROL})) << view->name;
        }
    }
    EXPECT_EQ(standard_view(Action::ViewAll), nullptr);
    EXPECT_EQ(standard_view(Action::Reload), nullptr);
    EXPECT_STREQ(standard_view(Action::Diagonal)->name, "Diagonal");
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
