// The window under random hands, and over many edits. CSGSCOPE_SOAK=5000 in the environment: so many actions, and a
// tenth as many edits.
#include <random>

#include <fmt/format.h>

#include "tests/ui/viewer/window_fixture.h"

namespace ui {
namespace {

using WindowSoak = WindowFixture;

int soak() {
    const char* const text = std::getenv("CSGSCOPE_SOAK");
    return text != nullptr ? std::atoi(text) : 0;
}

/// One action of xdotool, anywhere but in the menu bar, whose menu ends the program, and with no key that writes files.
std::string random_action(std::minstd_rand& random) {
    static const std::vector<std::string> keys{
        "s",      "l",          "a",    "b",     "g",  "x",       "p",    "v",      "m",      "f",       "t",
        "c",      "space",      "F6",   "F7",    "F8", "F9",      "F10",  "F11",    "F1",     "Escape",  "comma",
        "period", "ctrl+space", "Left", "Right", "Up", "4",       "5",    "8",      "0",      "shift+l", "equal",
        "minus",  "Tab",        "F5",   "w",     "e",  "shift+s", "Home", "ctrl+z", "ctrl+y", "ctrl+d",  "Delete"};
    const auto pick = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
    const int x = pick(2, 1277), y = pick(30, 797);
    const std::string at = fmt::format(" {} {}", x, y);
    switch (pick(0, 9)) {
        case 0:
        case 1:
            return "mousemove" + at + " click 1";
        case 2:
            return "mousemove" + at + " click " + std::to_string(pick(2, 5));
        case 3:
        case 4: {
            const std::string button = std::to_string(pick(1, 3));
            const int to_x = pick(2, 1277), to_y = pick(30, 797);
            const std::string to = fmt::format(" {} {}", to_x, to_y);
            return "mousemove" + at + " mousedown " + button + " mousemove" + to + " mouseup " + button;
        }
        case 5:
            return "mousemove" + at;
        default:
            return "key " + keys[static_cast<std::size_t>(pick(0, static_cast<int>(keys.size()) - 1))];
    }
}

TEST_F(WindowSoak, RandomActionsDoNoHarm) {
    const int actions = std::max(soak(), 120);
    open();
    wait_for_picture();
    std::minstd_rand random(20);
    for (int i = 0; i < actions; ++i) {
        const std::string action = random_action(random);
        robot(action);
        ASSERT_EQ(program_->wait(0s), std::nullopt) << "ended by action " << i << ": " << action << "\n"
                                                    << folder_.read("output.txt");
    }
    // What was edited by hand goes back to the beginning.
    robot("key Escape key Escape key Escape");
    for (int i = 0; i < 500 && frames().back().at("edits") > 0; ++i) {
        robot("key ctrl+z sleep 0.05");
    }
    EXPECT_EQ(frames().back().at("unsaved"), false);
    // It still follows its file.
    const Json last = frames().back();
    folder_.replace("model.scad", "cube(7);\n");
    wait_for(0, [&](const Json& frame) { return frame.at("generation") > last.at("generation"); });
    EXPECT_EQ(folder_.read("output.txt"), "");
}

TEST_F(WindowSoak, EditsLeaveNothingBehind) {
    const int edits = std::max(soak() / 10, 24);
    open();
    wait_for_picture();
    std::uint64_t generation = frames().back().at("generation");
    const auto edit = [&](int i) {
        folder_.replace("model.scad", "difference() { cube(20, center = true); cylinder(r = " +
                                          std::to_string(3 + i % 7) + ", h = 40, center = true, $fn = 200); }\n");
        const Json frame = wait_for(frames().size() - 1, [&](const Json& each) {
            return finished(each) && each.at("generation") > generation;
        });
        generation = frame.value("generation", generation);
    };
    for (int i = 0; i < edits / 3; ++i) {
        edit(i);
    }
    const std::size_t before = program_->resident_bytes();
    for (int i = edits / 3; i < edits; ++i) {
        edit(i);
    }
    EXPECT_LT(program_->resident_bytes(), before + (std::size_t{16} << 20));
}

}  // namespace
}  // namespace ui
