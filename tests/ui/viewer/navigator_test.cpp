// From events of the mouse to the camera.
#include "ui/viewer/navigator.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace ui {
namespace {

class NavigatorTest : public testing::Test {
  protected:
    void send(PointerKind kind, glm::dvec2 position, Button button = Button::None, bool shift = false) {
        PointerEvent event;
        event.kind = kind;
        event.position = position;
        event.button = button;
        event.modifiers = shift ? GLFW_MOD_SHIFT : 0;
        event.time = time_ += 0.1;
        navigator_.handle(event, picture_, free_, camera_);
    }
    void drag(Button button, bool shift = false) {
        send(PointerKind::Press, {200, 200}, button, shift);
        EXPECT_EQ(navigator_.dragging(), free_);
        send(PointerKind::Move, {230, 215});
        send(PointerKind::Release, {230, 215}, button);
        EXPECT_FALSE(navigator_.dragging());
    }
    bool turned() const { return camera_.rotation != base::Camera{}.rotation; }
    bool shifted() const { return camera_.target != base::Camera{}.target; }

    Rectangle picture_{{100, 50}, {800, 600}};
    bool free_ = true;
    Navigator navigator_;
    base::Camera camera_;
    double time_ = 0;
};

TEST_F(NavigatorTest, AClickIsNoDrag) {
    drag(Button::Left);
    EXPECT_EQ(navigator_.take_click(), std::nullopt);
    send(PointerKind::Press, {220, 170}, Button::Left);
    send(PointerKind::Move, {221, 171});  // An unsteady hand.
    send(PointerKind::Release, {221, 171}, Button::Left);
    EXPECT_EQ(navigator_.take_click(), glm::dvec2(121, 121));
    EXPECT_EQ(navigator_.take_click(), std::nullopt) << "once";
    send(PointerKind::Press, {220, 170}, Button::Right);
    send(PointerKind::Release, {220, 170}, Button::Right);
    EXPECT_EQ(navigator_.take_click(), std::nullopt);
}

TEST_F(NavigatorTest, LeftDragTurns) {
    drag(Button::Left);
    EXPECT_TRUE(turned());
    EXPECT_FALSE(shifted());
}

TEST_F(NavigatorTest, TurnsAboutTheSurfaceUnderThePointer) {
    const glm::dvec3 surface(30, -20, 10);
    const auto place = [&] { return glm::dvec3(camera_.eye_from_world() * glm::dvec4(surface, 1)); };
    send(PointerKind::Press, {300, 250}, Button::Left);
    EXPECT_EQ(navigator_.take_question(), glm::dvec2(200, 200));
    EXPECT_EQ(navigator_.take_question(), std::nullopt) << "once";
    const glm::dvec3 before = place();
    navigator_.answer(surface);
    send(PointerKind::Move, {380, 310});
    EXPECT_TRUE(turned());
    EXPECT_NEAR(glm::distance(place(), before), 0, 1e-9) << "it keeps its place in the picture";
    send(PointerKind::Release, {380, 310}, Button::Left);
    send(PointerKind::Press, {300, 250}, Button::Left);  // Another question, which nobody has answered yet.
    const glm::dvec3 target = camera_.target;
    send(PointerKind::Move, {280, 250});
    EXPECT_EQ(camera_.target, target) << "about the target";
}

TEST_F(NavigatorTest, TheWheelStaysBeforeTheSurface) {
    const glm::dvec3 surface(30, -20, 10);
    send(PointerKind::Scroll, {300, 250});
    EXPECT_TRUE(navigator_.take_question().has_value());
    navigator_.answer(surface);
    const auto depth = [&] { return -(camera_.eye_from_world() * glm::dvec4(surface, 1)).z; };
    const double before = depth();
    PointerEvent event;
    event.kind = PointerKind::Scroll;
    event.position = {301, 250};
    event.amount = 1;
    for (int i = 0; i < 60; ++i) {
        navigator_.handle(event, picture_, true, camera_);
    }
    EXPECT_EQ(navigator_.take_question(), std::nullopt) << "the answer still holds";
    EXPECT_GT(depth(), 0);
    EXPECT_LT(depth(), before / 1000);
    event.position = {400, 250};
    navigator_.handle(event, picture_, true, camera_);
    EXPECT_TRUE(navigator_.take_question().has_value()) << "another place";
}

TEST_F(NavigatorTest, RightAndMiddleAndShiftShift) {
    for (const Button button : {Button::Right, Button::Middle, Button::Left}) {
        camera_ = {};
        drag(button, button == Button::Left);
        EXPECT_FALSE(turned());
        EXPECT_TRUE(shifted());
    }
}

TEST_F(NavigatorTest, MovingWithoutAButtonDoesNothing) {
    send(PointerKind::Move, {200, 200});
    send(PointerKind::Move, {300, 250});
    EXPECT_EQ(camera_, base::Camera{});
}

TEST_F(NavigatorTest, ADragBeginsInThePictureOnlyButMayLeaveIt) {
    send(PointerKind::Press, {50, 200}, Button::Left);
    send(PointerKind::Move, {300, 250});
    EXPECT_EQ(camera_, base::Camera{});
    send(PointerKind::Release, {300, 250}, Button::Left);

    send(PointerKind::Press, {110, 200}, Button::Left);
    send(PointerKind::Move, {20, 200});
    EXPECT_TRUE(turned());
}

TEST_F(NavigatorTest, TheInterfaceOverThePictureTakesTheMouse) {
    free_ = false;
    drag(Button::Left);
    send(PointerKind::Scroll, {200, 200});
    EXPECT_EQ(camera_, base::Camera{});
}

TEST_F(NavigatorTest, ASecondButtonDoesNotEndTheDragOfTheFirst) {
    send(PointerKind::Press, {200, 200}, Button::Left);
    send(PointerKind::Press, {200, 200}, Button::Right);
    send(PointerKind::Release, {200, 200}, Button::Right);
    send(PointerKind::Move, {230, 200});
    EXPECT_TRUE(turned());
    EXPECT_FALSE(shifted());
}

TEST_F(NavigatorTest, TheWheelComesNearer) {
    PointerEvent event;
    event.kind = PointerKind::Scroll;
    event.position = {500, 350};
    event.amount = 1;
    navigator_.handle(event, picture_, true, camera_);
    EXPECT_LT(camera_.distance, base::Camera{}.distance);
    event.amount = -1;
    navigator_.handle(event, picture_, true, camera_);
    EXPECT_NEAR(camera_.distance, base::Camera{}.distance, 1e-9);
}

TEST_F(NavigatorTest, ADoubleClickIsToldOnceFromThePicturesCorner) {
    send(PointerKind::Press, {300, 250}, Button::Left);
    send(PointerKind::Release, {300, 250}, Button::Left);
    EXPECT_EQ(navigator_.take_double_click(), std::nullopt);
    send(PointerKind::Press, {301, 250}, Button::Left);
    EXPECT_EQ(navigator_.take_double_click(), glm::dvec2(201, 200));
    EXPECT_EQ(navigator_.take_double_click(), std::nullopt);
    send(PointerKind::Release, {301, 250}, Button::Left);
    send(PointerKind::Press, {301, 250}, Button::Left);  // A third click begins anew.
    EXPECT_EQ(navigator_.take_double_click(), std::nullopt);
}

TEST_F(NavigatorTest, SlowOrDistantClicksAreNotOne) {
    send(PointerKind::Press, {300, 250}, Button::Left);
    send(PointerKind::Release, {300, 250}, Button::Left);
    time_ += 1;
    send(PointerKind::Press, {300, 250}, Button::Left);
    send(PointerKind::Release, {300, 250}, Button::Left);
    EXPECT_EQ(navigator_.take_double_click(), std::nullopt);
    send(PointerKind::Press, {340, 250}, Button::Left);
    EXPECT_EQ(navigator_.take_double_click(), std::nullopt);
}

TEST_F(NavigatorTest, PresetsMoveAsOtherProgramsDo) {
    navigator_.set_preset(mouse_preset("Blender"));
    drag(Button::Left);
    EXPECT_FALSE(turned());
    EXPECT_FALSE(shifted());
    drag(Button::Middle);
    EXPECT_TRUE(turned());
    EXPECT_FALSE(shifted());
    drag(Button::Middle, true);
    EXPECT_TRUE(shifted());
    camera_ = {};
    send(PointerKind::Press, {220, 170}, Button::Left);
    send(PointerKind::Release, {220, 170}, Button::Left);
    EXPECT_TRUE(navigator_.take_click()) << "the left button selects everywhere";

    navigator_.set_preset(mouse_preset("FreeCAD"));
    send(PointerKind::Press, {200, 200}, Button::Middle);
    send(PointerKind::Press, {200, 200}, Button::Left);
    send(PointerKind::Move, {230, 215});
    EXPECT_TRUE(turned());
    EXPECT_FALSE(shifted());
    send(PointerKind::Release, {230, 215}, Button::Left);
    send(PointerKind::Release, {230, 215}, Button::Middle);
    EXPECT_FALSE(navigator_.dragging());

    navigator_.set_preset(0);
    const double distance = camera_.distance;
    drag(Button::Right, true);
    EXPECT_NE(camera_.distance, distance) << "Shift + right zooms";
    EXPECT_EQ(mouse_preset("Nothing"), 0U);
}

}  // namespace
}  // namespace ui
