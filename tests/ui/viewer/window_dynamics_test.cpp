// Depictions of motion and labels in the window.
#include "tests/ui/viewer/window_fixture.h"

namespace ui {
namespace {

constexpr const char* kDoor =
    "module door() cube([20, 2, 30]);\n"
    "module post() translate([-4, 0, 0]) cube([4, 2, 34]);\n"
    "rotate(-60 * $t) door();\n"
    "post();\n";

/// Of arrows.
bool is_arrow(const std::uint8_t* p) {
    return p[0] > 100 && p[1] < p[0] / 2 && p[2] < p[0] / 2;
}

class WindowDynamics : public WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        folder_.write("model.scad", kDoor);
    }
    Json wait_for_dynamics(std::size_t from, const std::function<bool(const Json&)>& wanted) {
        return wait_for(from, [&](const Json& frame) { return finished(frame) && wanted(frame.at("dynamics")); });
    }
    /// Of the model's picture: errors in the panel are red as well.
    std::size_t arrow_pixels() const {
        constexpr int kWidth = 960, kHeight = 610;
        const base::Image image = display_->screenshot();
        std::size_t found = 0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                found += is_arrow(&image.rgba[4 * static_cast<std::size_t>(y * image.width + x)]) ? 1 : 0;
            }
        }
        return found;
    }
    /// Waits until so many pixels of the picture are as arrows are.
    testing::AssertionResult shows_arrow(std::size_t least, std::size_t most = ~std::size_t{0}) const {
        std::size_t found = 0;
        for (int i = 0; i < 100; ++i) {
            found = arrow_pixels();
            if (found >= least && found <= most) {
                return testing::AssertionSuccess();
            }
            std::this_thread::sleep_for(100ms);
        }
        return testing::AssertionFailure() << found << " red pixels";
    }
};

TEST_F(WindowDynamics, AnExpressionIsTypedAndSeen) {
    open();
    wait_for_picture();
    ASSERT_TRUE(shows_arrow(0, 100));
    std::size_t from = frames().size();
    robot("key d");
    wait_for_dynamics(from, [](const Json& d) { return d.at("bodies") == 1; });
    from = frames().size();
    robot("mousemove 1100 70 click 1 sleep 0.5 type 'rotation {door}'");
    robot("key Return");
    wait_for_dynamics(from, [](const Json& d) { return d.at("depictions") == 1 && d.at("error") == ""; });
    EXPECT_TRUE(shows_arrow(300));
    // Turned, the motion is not looked for again.
    from = frames().size();
    robot("mousemove 480 300 mousedown 1 mousemove 520 310 sleep 0.2 mousemove 560 320 mouseup 1");
    const Json turned = wait_for(from, [&](const Json& frame) {
        return finished(frame) && frame.at("camera") != frames()[from - 1].at("camera");
    });
    EXPECT_EQ(turned.at("dynamics").at("searches"), 1);
    // A fault is told in place, and the rest stays.
    from = frames().size();
    robot("mousemove 1100 70 click 1 key End type ' [0'");
    wait_for_dynamics(from, [](const Json& d) { return d.at("error").get<std::string>().starts_with("expected ']'"); });
    EXPECT_TRUE(shows_arrow(0, 100)) << "no expression, no arrow";
}

TEST_F(WindowDynamics, OptionsOpenTheWindowWithThem) {
    open({"--depict", "rotation {door}", "--label", "post=A post of oak", "--callouts"});
    const Json shown =
        wait_for_dynamics(0, [](const Json& d) { return d.at("depictions") == 1 && d.at("labels") == 1; });
    EXPECT_EQ(shown.at("dynamics").at("error"), "");
    EXPECT_TRUE(shows_arrow(300));
}

TEST_F(WindowDynamics, WhatIsClickedIsLabeled) {
    open();
    wait_for_picture();
    std::size_t from = frames().size();
    robot("key d");
    wait_for_dynamics(from, [](const Json& d) { return d.at("bodies") == 1; });
    from = frames().size();
    robot("mousemove 480 330 click 1");
    wait_for(from, [](const Json& frame) { return frame.at("selected") != ""; });
    from = frames().size();
    robot("mousemove 1195 263 click 1");
    wait_for_dynamics(from, [](const Json& d) { return d.at("labels") == 1 && d.at("error") == ""; });
}

}  // namespace
}  // namespace ui
