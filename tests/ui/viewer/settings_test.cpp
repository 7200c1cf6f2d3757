// What is chosen for all runs: keys, mouse, look.
#include "ui/viewer/settings.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "ui/viewer/mouse_preset.h"

namespace ui {
namespace {

TEST(Keys, AKeyThatIsGivenIsTakenFromOthers) {
    Keys keys;
    EXPECT_EQ(keys.action_of({GLFW_KEY_S, 0}), Action::NextStyle);
    keys.set(Action::ToggleGrid, {{GLFW_KEY_S, 0}});
    EXPECT_EQ(keys.action_of({GLFW_KEY_S, 0}), Action::ToggleGrid);
    EXPECT_EQ(keys.action_of({GLFW_KEY_G, 0}), std::nullopt);
    EXPECT_EQ(keys.first_text(Action::NextStyle), "");
    EXPECT_EQ(keys.first_text(Action::ToggleGrid), "S");
    EXPECT_EQ(keys.changed().size(), 2U);
    keys.set(Action::ToggleGrid, {{GLFW_KEY_G, 0}});
    keys.set(Action::NextStyle, {{GLFW_KEY_S, 0}});
    EXPECT_EQ(keys, Keys()) << "as by default";
}

TEST(Keys, WhatIsWrittenIsReadAgain) {
    for (const ActionInfo& each : actions()) {
        for (const Chord& chord : Keys().of(each.action)) {
            EXPECT_EQ(chord_of(text(chord)), chord) << text(chord);
        }
    }
    EXPECT_EQ(chord_of("Ctrl+Alt+Delete"), (Chord{GLFW_KEY_DELETE, GLFW_MOD_CONTROL | GLFW_MOD_ALT}));
    EXPECT_EQ(chord_of("Hyper+X"), std::nullopt);
    EXPECT_EQ(chord_of(""), std::nullopt);
}

TEST(Settings, AreKeptInAFile) {
    const test_support::TemporaryFolder folder;
    const std::filesystem::path file = folder.path("state/settings");
    EXPECT_EQ(read_settings(file), Settings());
    EXPECT_EQ(read_settings(""), Settings());
    Settings settings;
    settings.mouse = mouse_preset("FreeCAD");
    settings.light = true;
    settings.text_size = 1.3;
    settings.keys.set(Action::ToggleGrid, {{GLFW_KEY_F5, GLFW_MOD_SHIFT}, {GLFW_KEY_PAGE_UP, 0}});
    settings.keys.set(Action::Reload, {});
    write_settings(file, settings);
    EXPECT_EQ(read_settings(file), settings);
    folder.write("state/settings", "theme = light\nnonsense\nmouse = Nobody\ntext size = 1.29\nkey Grid = What\n");
    const Settings read = read_settings(file);
    EXPECT_TRUE(read.light);
    EXPECT_EQ(read.mouse, 0U);
    EXPECT_EQ(read.text_size, 1.3);
    EXPECT_TRUE(read.keys.of(Action::ToggleGrid).empty());
}

}  // namespace
}  // namespace ui
