// The window's tools from outside: view cube, section handle, flying.
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
    std::this_thread::sleep_for(500ms);
    EXPECT_EQ(frames().back().at("camera").at("rotation"), Json({0, 0, 0}));
}

TEST_F(WindowTools, ASectionIsDraggedInThePicture) {
    open();
    wait_for_picture();
    robot("mousemove 1174 339 click 1");  // Z
    std::size_t from = frames().size();
    wait_for_picture(from);
    std::this_thread::sleep_for(500ms);
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

}  // namespace
}  // namespace ui
