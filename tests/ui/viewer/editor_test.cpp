// How editors are told where to go.
#include "ui/viewer/editor.h"

#include <gtest/gtest.h>

namespace ui {
namespace {

using Words = std::vector<std::string>;

TEST(Editor, EachIsToldInItsOwnWay) {
    EXPECT_EQ(editor_command("code --wait", "/a b.scad", 3, 7), (Words{"code", "--wait", "--goto", "/a b.scad:3:7"}));
    EXPECT_EQ(editor_command("/usr/bin/kate", "a.scad", 3, 7),
              (Words{"/usr/bin/kate", "--line", "3", "--column", "7", "a.scad"}));
    EXPECT_EQ(editor_command("emacsclient -n", "a.scad", 3, 7), (Words{"emacsclient", "-n", "+3:7", "a.scad"}));
    EXPECT_EQ(editor_command("vim", "a.scad", 3, 7), (Words{"x-terminal-emulator", "-e", "vim", "+3", "a.scad"}));
    EXPECT_EQ(editor_command("own", "a.scad", 3, 7), (Words{"own", "+3", "a.scad"}));
    EXPECT_EQ(editor_command("  ", "a.scad", 3, 7), Words{});
}

TEST(Editor, WhyNotIsTold) {
    setenv("VISUAL", "", 1);
    setenv("EDITOR", "", 1);
    EXPECT_NE(open_editor("a.scad", 1, 1).find("$VISUAL"), std::string::npos);
    setenv("VISUAL", "/nowhere/editor", 1);
    EXPECT_NE(open_editor("a.scad", 1, 1).find("/nowhere/editor"), std::string::npos);
    setenv("VISUAL", "true", 1);
    EXPECT_EQ(open_editor("a.scad", 1, 1), "");
}

}  // namespace
}  // namespace ui
