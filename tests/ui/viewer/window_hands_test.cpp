// The program edited by hand, from outside: mouse and keys in, the text of the file out.
#include <cmath>
#include <random>

#include "tests/ui/viewer/window_fixture.h"

namespace ui {
namespace {

/// From above: a unit is 15.1 pixels, and the origin is seen at kMiddle.
const std::vector<std::string> kFromAbove{"--camera", "0,0,0,0,0,0,100", "--projection", "o"};
constexpr glm::ivec2 kMiddle{485, 324};
constexpr double kUnit = 15.1;

std::string to(const glm::dvec2& place) {
    const glm::ivec2 pixel = kMiddle + glm::ivec2(glm::round(glm::dvec2(kUnit * place.x, -kUnit * place.y)));
    return "mousemove " + std::to_string(pixel.x) + " " + std::to_string(pixel.y) + " sleep 0.2 ";
}

class WindowHands : public WindowFixture {
  protected:
    /// With the tool in hand, and what is seen there selected.
    void begin(const std::string& text, const glm::dvec2& select) {
        folder_.write("model.scad", text);
        open(kFromAbove);
        wait_for_picture();
        robot("key w");
        wait_for(0, [](const Json& frame) { return frame.at("tool") == "move"; });
        robot(to(select) + "click 1");
        wait_for(0, [](const Json& frame) { return frame.at("selected") != ""; });
    }
    Json wait_for_edits(int edits) {
        return wait_for(0, [&](const Json& frame) {
            return frame.at("edits") == edits && frame.at("evaluating") == false && frame.at("state") == "good" &&
                   finished(frame);
        });
    }
    /// The file, as soon as that is so.
    std::string saved(const std::function<bool(const std::string&)>& wanted) {
        robot("key ctrl+s");
        for (int i = 0; i < 100 && !wanted(folder_.read("model.scad")); ++i) {
            std::this_thread::sleep_for(50ms);
        }
        return folder_.read("model.scad");
    }
    std::string saved_as(const std::string& text) {
        return saved([&](const std::string& file) { return file == text; });
    }
    void add(const std::string& shape) {
        robot("key F3");
        ASSERT_TRUE(shows(kForm, 10'000));
        robot("type --delay 60 '" + shape + "'");
        robot("key Return");
    }
};

TEST_F(WindowHands, AnArrowThatIsDraggedEditsTheText) {
    const std::string before = "cube([10, 10, 2]); // the plate\ntranslate([0, 0, 2]) cube(4);\n";
    begin(before, {3, 1});
    // The arrow of x begins at the middle of the cube and is 90 pixels long.
    robot(to({6, 2}) + "mousedown 1 " + to({7, 2}) + to({9, 2.1}) + to({11, 2.1}));
    wait_for(0, [](const Json& frame) { return frame.at("found") == "X 5"; });
    robot("mouseup 1");
    wait_for_edits(1);
    const std::string after = "cube([10, 10, 2]); // the plate\ntranslate([5, 0, 2]) cube(4);\n";
    EXPECT_EQ(folder_.read("model.scad"), before) << "not before it is saved";
    EXPECT_EQ(saved_as(after), after);
    EXPECT_EQ(frames().back().at("selected"), "model.scad:2") << "it is selected still";
    // The next drag begins where it lies now; what is typed counts.
    robot(to({7, 5}) + "mousedown 1 " + to({7, 5.5}) + to({7, 6}) + "key 2 key period key 5");
    wait_for(0, [](const Json& frame) { return frame.at("found") == "Y 2.5   2.5_"; });
    robot("mouseup 1");
    wait_for_edits(2);
    const std::string typed = "cube([10, 10, 2]); // the plate\ntranslate([5, 2.5, 2]) cube(4);\n";
    EXPECT_EQ(saved_as(typed), typed);
    robot("key ctrl+z");
    wait_for(frames().size() - 1, [](const Json& frame) { return frame.at("edits") == 1; });
    robot("key ctrl+z");
    wait_for(frames().size() - 1, [](const Json& frame) { return frame.at("edits") == 0; });
    EXPECT_EQ(saved_as(before), before);
    robot("key ctrl+shift+z key ctrl+y");
    wait_for(frames().size() - 1, [](const Json& frame) { return frame.at("edits") == 2; });
    EXPECT_EQ(saved_as(typed), typed);
}

TEST_F(WindowHands, ADimensionThatIsDraggedEditsTheText) {
    begin("cube([6, 4, 2]); // plate\n", {3, 1});
    std::size_t from = frames().size();
    robot("key e");
    wait_for(from, [](const Json& frame) { return frame.at("tool") == "size"; });
    std::this_thread::sleep_for(500ms);
    robot(to({6, 2}) + "mousedown 1 " + to({7, 2}) + to({8, 2.1}));
    wait_for(0, [](const Json& frame) { return frame.at("found") == "x 8"; });
    robot(to({9, 2.1}) + "mouseup 1");
    wait_for_edits(1);
    const std::string after = "cube([9, 4, 2]); // plate\n";
    EXPECT_EQ(saved_as(after), after);
    robot("key ctrl+z");
    wait_for(frames().size() - 1, [](const Json& frame) { return frame.at("edits") == 0; });
}

TEST_F(WindowHands, ADimensionThatIsComputedIsDraggedToo) {
    begin("a = 2;\ncube([3 * a, 4, 2]); // plate\n", {3, 1});
    robot("key e");
    wait_for(0, [](const Json& frame) { return frame.at("tool") == "size"; });
    std::this_thread::sleep_for(500ms);
    robot(to({6, 2}) + "mousedown 1 " + to({7, 2}) + to({8, 2.1}));
    wait_for(0, [](const Json& frame) { return frame.at("found") == "x 8"; });
    robot(to({9, 2.1}) + "mouseup 1");
    wait_for_edits(1);
    const std::string after = "a = 2;\ncube([4.5 * a, 4, 2]); // plate\n";
    EXPECT_EQ(saved_as(after), after);
}

TEST_F(WindowHands, AnAxisThatIsDraggedScalesIt) {
    begin("translate([1, 1, 0]) cube([6, 2, 2]); // bar\n", {4, 2});
    robot("key k");
    wait_for(0, [](const Json& frame) { return frame.at("tool") == "scale"; });
    std::this_thread::sleep_for(500ms);
    // The handle of x is 80 pixels from the origin of the cube.
    const double reach = 80 / kUnit;
    robot(to({1 + reach, 1}) + "mousedown 1 " + to({1 + 1.2 * reach, 1}) + to({1 + 1.5 * reach, 1}));
    wait_for(0, [](const Json& frame) { return frame.at("found") == "X × 1.5"; });
    robot("mouseup 1");
    wait_for_edits(1);
    const std::string after = "translate([1, 1, 0]) cube([9, 2, 2]); // bar\n";
    EXPECT_EQ(saved_as(after), after);
    robot("key ctrl+z");
    wait_for(frames().size() - 1, [](const Json& frame) { return frame.at("edits") == 0; });
}

TEST_F(WindowHands, WithShiftItComesToLieInLine) {
    begin("cube([10, 10, 2]);\ntranslate([0, 0, 2]) cube(3);\n", {1, 1});
    // Its right side at that of the other: 7 to the right.
    robot(to({4, 1.5}) + "mousedown 1 " + to({5, 1.5}) + "keydown shift " + to({8, 1.5}) + to({10.8, 1.6}));
    wait_for(0, [](const Json& frame) { return frame.at("found") == "X 7"; });
    robot("mouseup 1 keyup shift");
    wait_for_edits(1);
    const std::string after = "cube([10, 10, 2]);\ntranslate([7, 0, 2]) cube(3);\n";
    EXPECT_EQ(saved_as(after), after);
}

TEST_F(WindowHands, ARingThatIsDraggedTurnsIt) {
    begin("translate([1, 1, 0]) cube([6, 2, 2]); // bar\n", {4, 2});
    const std::size_t from = frames().size();
    robot("key r");
    wait_for(from, [](const Json& frame) { return frame.at("tool") == "turn"; });
    std::this_thread::sleep_for(500ms);
    // Seen from above the ring of z is a circle of 80 pixels around the origin of the cube.
    const double reach = 80 / kUnit;
    const auto on_ring = [&](double degrees, double away) {
        const double angle = degrees * 3.14159265358979 / 180;
        return to(glm::dvec2(1, 1) + away * reach * glm::dvec2(std::cos(angle), std::sin(angle)));
    };
    robot(on_ring(-40, 1) + "mousedown 1 " + on_ring(-30, 1) + on_ring(-12, 1.5) + on_ring(-10, 1.5));
    wait_for(0, [](const Json& frame) { return frame.at("found") == "Z 30°"; });
    robot("mouseup 1");
    wait_for_edits(1);
    const std::string after = "translate([1, 1, 0]) rotate([0, 0, 30]) cube([6, 2, 2]); // bar\n";
    EXPECT_EQ(saved_as(after), after);
    robot(on_ring(-40, 1) + "mousedown 1 " + on_ring(-30, 1) + on_ring(-20, 1) + "key 1 key 5");
    wait_for(0, [](const Json& frame) { return frame.at("found") == "Z 15°   15_"; });
    robot("mouseup 1");
    wait_for_edits(2);
    const std::string typed = "translate([1, 1, 0]) rotate([0, 0, 45]) cube([6, 2, 2]); // bar\n";
    EXPECT_EQ(saved_as(typed), typed);
    robot("key ctrl+z");
    wait_for(frames().size() - 1, [](const Json& frame) { return frame.at("edits") == 1; });
}

TEST_F(WindowHands, EscapeLetsGoOfWhatIsDragged) {
    begin("cube(4);\n", {1, 1});
    robot(to({6, 2}) + "mousedown 1 " + to({7, 2}) + to({9, 2}));
    wait_for(0, [](const Json& frame) { return frame.at("found") == "X 3"; });
    robot("key Escape");
    wait_for(frames().size() - 1, [](const Json& frame) { return frame.at("found") == ""; });
    robot("mouseup 1");
    std::this_thread::sleep_for(700ms);
    EXPECT_EQ(frames().back().at("edits"), 0);
    EXPECT_EQ(frames().back().at("tool"), "move");
}

TEST_F(WindowHands, AddsByThePalette) {
    folder_.write("model.scad", "cube(4);\n");
    open(kFromAbove);
    wait_for_picture();
    add("cylinder");
    wait_for_edits(1);
    wait_for(0, [](const Json& frame) { return frame.at("selected") == "model.scad:2"; });
    const std::string after = "cube(4);\ntranslate([9, 2, 0]) cylinder(h = 5, d = 5);\n";
    EXPECT_EQ(saved_as(after), after);
    robot("key ctrl+d");
    wait_for_edits(2);
    wait_for(0, [](const Json& frame) { return frame.at("selected") == "model.scad:3"; });
    robot("key Delete");
    wait_for_edits(3);
    EXPECT_EQ(saved_as(after), after);
}

TEST_F(WindowHands, TypesIntoTheText) {
    folder_.write("model.scad", "cube(4);\n");
    open(kFromAbove);
    wait_for_picture();
    robot("key t sleep 0.5 mousemove 200 62 click 1 sleep 0.3 key End key Return sleep 0.2");
    robot("type --delay 60 'sphere(3)'");  // Without its end.
    wait_for(0, [](const Json& frame) { return frame.at("state") == "failed"; });
    robot("type --delay 60 ';'");
    wait_for(frames().size() - 1, [](const Json& frame) { return frame.at("state") == "good"; });
    const std::string after = "cube(4);\nsphere(3);\n";
    EXPECT_EQ(saved_as(after), after) << "s, with Ctrl, is a shortcut there too";
    EXPECT_EQ(frames().back().at("style"), "shaded") << "and without it is none";
    const int steps = frames().back().at("edits");
    for (int i = 0; i < steps; ++i) {
        robot("key ctrl+z sleep 0.2");
    }
    EXPECT_EQ(saved_as("cube(4);\n"), "cube(4);\n");
}

TEST_F(WindowHands, EditsOfAnotherProgramAreMerged) {
    folder_.write("model.scad", "cube(4);\nsphere(3);\n");
    open(kFromAbove);
    wait_for_picture();
    add("cube");
    wait_for_edits(1);
    folder_.write("model.scad", "cube(4); // changed\nsphere(2);\n");
    wait_for_edits(2);
    const std::string file = saved([](const std::string& text) { return text.find("translate") != std::string::npos; });
    EXPECT_TRUE(file.starts_with("cube(4); // changed\nsphere(2);\ntranslate([")) << file;
}

TEST_F(WindowHands, QuittingAsksForWhatIsNotSaved) {
    folder_.write("model.scad", "cube(4);\n");
    open(kFromAbove);
    wait_for_picture();
    add("cube");
    wait_for_edits(1);
    robot("key ctrl+q");
    ASSERT_TRUE(shows(kForm, 10'000));
    EXPECT_FALSE(program_->wait(1s)) << "it asks";
    robot("key Escape");
    ASSERT_TRUE(shows(kForm, 0, 5'000));
    robot("key ctrl+q");
    ASSERT_TRUE(shows(kForm, 10'000));
    robot("key Return");
    ASSERT_EQ(program_->wait(kPatience), 0);
    EXPECT_NE(folder_.read("model.scad").find("translate"), std::string::npos) << "Return saves";
}

TEST_F(WindowHands, WhatIsNotSavedOutlivesAKill) {
    std::mt19937 random(1);
    const std::string before = "cube(4);\n";
    int kept = 0;
    for (int i = 0; i < 3; ++i) {
        folder_.write("model.scad", before);
        folder_.write("frames.json", "");
        open(kFromAbove);
        wait_for_picture();
        add("cube");
        wait_for_edits(1);
        std::this_thread::sleep_for(std::chrono::milliseconds(random() % 2500));
        const bool surely = i == 2;
        if (surely) {
            std::this_thread::sleep_for(2s);
        }
        program_->kill_at_once();
        EXPECT_EQ(folder_.read("model.scad"), before);
        folder_.write("frames.json", "");
        open(kFromAbove);
        wait_for_picture();
        std::this_thread::sleep_for(500ms);
        if (count(kForm) > 10'000) {
            robot("key Return");
            wait_for_edits(1);
            const std::string file =
                saved([](const std::string& text) { return text.find("translate") != std::string::npos; });
            EXPECT_TRUE(file.starts_with("cube(4);\ntranslate([")) << file;
            ++kept;
        } else {
            EXPECT_FALSE(surely) << "it was kept long before";
        }
        robot("key ctrl+q");
        ASSERT_EQ(program_->wait(kPatience), 0);
    }
    EXPECT_GE(kept, 1);
}

}  // namespace
}  // namespace ui
