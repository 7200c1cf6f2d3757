// The window's tools from outside: view cube, section handle, flying.
#include <set>

#include "tests/ui/viewer/window_fixture.h"

namespace ui {
namespace {

using WindowTools = WindowFixture;

TEST_F(WindowTools, TheViewCubeTurnsTheCamera) {
    open();
    const Json first = wait_for_picture();
    std::size_t from = frames().size();
    robot("mousemove 914 61 click 1");  // Its upper face.
    wait_for(from, [&](const Json& frame) { return frame.at("camera").at("rotation") == Json({0, 0, 0}); });
    std::size_t between = 0;
    for (const Json& frame : frames()) {
        const double tilt = frame.at("camera").at("rotation")[0];
        between += tilt > 0 && tilt < 55 ? 1 : 0;
    }
    EXPECT_GE(between, 2U) << "the turn is seen";
    EXPECT_EQ(frames().back().at("selected"), "") << "the click was the cube's";
    from = frames().size();
    robot("key b mousemove 914 81 click 1");  // Now it is not there.
    std::this_thread::sleep_for(1500ms);
    EXPECT_EQ(frames().back().at("camera").at("rotation"), Json({0, 0, 0}));
}

TEST_F(WindowTools, ASectionIsDraggedInThePicture) {
    open();
    wait_for_picture();
    robot("mousemove 1174 339 click 1");  // Z
    std::size_t from = frames().size();
    wait_for_picture(from);
    std::this_thread::sleep_for(1500ms);
    const std::size_t half = count(is_face);
    from = frames().size();
    const Json camera = frames().back().at("camera");
    robot("mousemove 485 300 mousedown 1 mousemove 485 310 mousemove 485 330 mousemove 485 345 mouseup 1");
    wait_for_picture(from);
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (count(is_face) > half * 4 / 5 && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(100ms);
    }
    EXPECT_LT(count(is_face), half * 4 / 5) << "deeper";
    EXPECT_EQ(frames().back().at("camera"), camera) << "the drag was the handle's";
}

TEST_F(WindowTools, FliesIntoTheSolid) {
    open();
    const Json first = wait_for_picture();
    std::size_t from = frames().size();
    robot("key f");
    wait_for(from, [](const Json& frame) { return frame.at("tool") == "fly"; });
    robot("keydown w sleep 1 keyup w key s");
    const Json flown = frames().back();
    EXPECT_EQ(flown.at("style"), first.at("style")) << "s is no shortcut now";
    EXPECT_EQ(flown.at("camera").at("rotation"), first.at("camera").at("rotation"));
    EXPECT_EQ(flown.at("camera").at("distance"), first.at("camera").at("distance"));
    EXPECT_NE(flown.at("camera").at("translation"), first.at("camera").at("translation"));
    from = frames().size();
    robot("key Escape");
    wait_for(from, [](const Json& frame) { return frame.at("tool") == "select"; });
}

TEST_F(WindowTools, MeasuresWhatIsClicked) {
    open({"--camera", "0,0,0,0,0,0,100", "--projection", "o"});  // From above: 20 is 302 pixels.
    wait_for_picture();
    robot("key m");
    wait_for(0, [](const Json& frame) { return frame.at("found").get<std::string>().starts_with("model 20 × 20"); });
    robot("mousemove 500 200 sleep 0.5 click 1");
    wait_for(0, [](const Json& frame) { return frame.at("found").get<std::string>().starts_with("plane"); });
    std::size_t from = frames().size();
    robot("key Escape");  // What was picked; then two corners, and the edge between them.
    wait_for(from, [](const Json& frame) { return frame.at("found").get<std::string>().starts_with("model"); });
    const int middle = 324, half = 151;
    const auto click = [&](int x, int y) {
        robot("mousemove " + std::to_string(x) + " " + std::to_string(y) + " sleep 0.5 click 1");
    };
    click(485 - half + 3, middle - half + 3);
    wait_for(from, [](const Json& frame) { return frame.at("found").get<std::string>().starts_with("point"); });
    click(485 + half - 3, middle - half + 3);
    const Json two = wait_for(
        from, [](const Json& frame) { return frame.at("found").get<std::string>().find("distance 20\n") != ~0UL; });
    EXPECT_EQ(two.at("selected"), "") << "clicks do not select now";
    robot("key Escape key Escape");
    wait_for(from, [](const Json& frame) { return frame.at("tool") == "select"; });
}

TEST_F(WindowTools, GridAndScalesAreInTheScene) {
    open();
    wait_for_picture();
    std::this_thread::sleep_for(1500ms);
    const std::size_t ground = count(kCornfield);
    const auto drawn_over = [&] {
        for (int i = 0; i < 50 && count(kCornfield) > ground - 5000; ++i) {
            std::this_thread::sleep_for(100ms);
        }
        return ground - count(kCornfield);
    };
    robot("key g");
    EXPECT_GT(drawn_over(), 5000U);
    robot("key g");
    ASSERT_TRUE(shows(kCornfield, ground - 20));
    const auto black = [](const std::uint8_t* p) { return p[0] == 0 && p[1] == 0 && p[2] == 0; };
    const std::size_t before = count(black);
    robot("key x");
    for (int i = 0; i < 50 && count(black) < before + 300; ++i) {
        std::this_thread::sleep_for(100ms);
    }
    EXPECT_GT(count(black), before + 300);
}

TEST_F(WindowTools, SettingsAreKept) {
    open();
    wait_for_picture();
    robot("key ctrl+comma");
    std::this_thread::sleep_for(1500ms);
    robot("key Escape");
    folder_.write(".local/state/csgscope/settings", "theme = light\nmouse = Blender\nkey Grid = J\n");
    robot("key ctrl+q");
    ASSERT_EQ(program_->wait(kPatience), 0);
    open();
    const Json first = wait_for_picture();
    EXPECT_TRUE(shows({240, 241, 242}, 50'000)) << "panels of the light theme";
    std::size_t from = frames().size();
    robot("mousemove 60 80 mousedown 1 mousemove_relative 60 40 mouseup 1");
    std::this_thread::sleep_for(1500ms);
    EXPECT_EQ(frames().back().at("camera"), first.at("camera")) << "the left button moves nothing";
    robot("mousemove 60 80 mousedown 2 mousemove_relative 60 40 mouseup 2");
    wait_for(from,
             [&](const Json& frame) { return frame.at("camera").at("rotation") != first.at("camera").at("rotation"); });
}

TEST_F(WindowTools, TheTreeSelectsHidesAndShowsAlone) {
    open({"--camera", "0,0,0,55,0,25,140"});
    wait_for_picture();
    robot("key F10");
    wait_for_picture(frames().size());
    std::size_t from = frames().size();
    robot("mousemove 120 129 click 1");  // The third row: the cylinder.
    wait_for(from, [](const Json& frame) { return frame.at("selected") == "model.scad:3"; });
    EXPECT_TRUE(shows({245, 201, 178}, 1000)) << "its ends, red and seen through, where it cuts nothing";
    robot("key Escape");
    wait_for(frames().size() - 1, [](const Json& frame) { return frame.at("selected") == ""; });
    from = frames().size();
    const Json before = frames().back();
    robot("mousemove 395 129 click 1");  // The cylinder only.
    wait_for(from,
             [&](const Json& frame) { return finished(frame) && frame.at("generation") != before.at("generation"); });
    for (int i = 0; i < 50 && count(is_cut) > 200; ++i) {
        std::this_thread::sleep_for(100ms);
    }
    EXPECT_LT(count(is_cut), 200U) << "a solid by itself";
    EXPECT_GT(count(is_face), 5'000U);
}

TEST_F(WindowTools, TimeRuns) {
    folder_.write("model.scad", "rotate(360 * $t) translate([5, 0, 0]) cube(10, center = true);\n");
    open();
    const Json first = wait_for_picture();
    robot("key F11");
    std::size_t from = frames().size();
    robot("key period");
    wait_for(from, [&](const Json& frame) {
        return finished(frame) && frame.at("step") == 1 && frame.at("generation") != first.at("generation");
    });
    from = frames().size();
    robot("key ctrl+space");
    std::this_thread::sleep_for(2s);
    robot("key ctrl+space");
    std::set<int> steps;
    std::set<std::uint64_t> models;
    const std::vector<Json> all = frames();
    for (std::size_t i = from; i < all.size(); ++i) {
        steps.insert(all[i].at("step").get<int>());
        models.insert(all[i].at("generation").get<std::uint64_t>());
        EXPECT_EQ(all[i].at("camera"), first.at("camera"));
    }
    EXPECT_GT(steps.size(), 5U);
    EXPECT_GT(models.size(), 5U) << "the pictures follow";
    const Json rested = wait_for_picture(frames().size() - 1);
    std::this_thread::sleep_for(1500ms);
    EXPECT_EQ(frames().back().at("step"), rested.at("step"));
}

}  // namespace
}  // namespace ui
