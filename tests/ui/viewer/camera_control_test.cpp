// The mouse and the camera.
#include "ui/viewer/camera_control.h"

#include <gtest/gtest.h>

#include "ui/pipeline/picture/pick.h"

namespace ui {
namespace {

constexpr glm::ivec2 kSize{640, 480};

/// Pixel of a world point, y down.
glm::dvec2 pixel_of(const base::Camera& camera, const glm::dvec3& point) {
    const base::View view(camera, kSize, glm::dvec3(-50), glm::dvec3(50));
    const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(point, 1.0);
    const glm::dvec2 unit = 0.5 * (glm::dvec2(clip) / clip.w + 1.0);
    return {unit.x * kSize.x, (1 - unit.y) * kSize.y};
}

void expect_near(const glm::dvec2& a, const glm::dvec2& b) {
    EXPECT_NEAR(a.x, b.x, 1e-6);
    EXPECT_NEAR(a.y, b.y, 1e-6);
}

class CameraControl : public testing::TestWithParam<base::Projection> {
  protected:
    CameraControl() {
        camera.projection = GetParam();
        camera.target = {3, -4, 5};
        camera.rotation = {63, 0, 211};
    }
    base::Camera camera;
};

TEST_P(CameraControl, ThePointOfTheTargetPlaneIsUnderTheCursor) {
    const glm::dvec2 cursor{100, 77};
    expect_near(pixel_of(camera, point_on_target_plane(camera, kSize, cursor)), cursor);
}

TEST_P(CameraControl, PanMovesTheTargetPlaneWithTheCursor) {
    const glm::dvec3 point = point_on_target_plane(camera, kSize, {200, 150});
    pan(camera, {33, -21}, kSize.y);
    expect_near(pixel_of(camera, point), {233, 129});
}

TEST_P(CameraControl, ZoomKeepsThePointUnderTheCursor) {
    const glm::dvec3 point{10, 12, -7};  // Well off the target plane.
    const glm::dvec2 before = pixel_of(camera, point);
    const double distance = camera.distance;
    zoom(camera, 0.8, point);
    expect_near(pixel_of(camera, point), before);
    EXPECT_NEAR(camera.distance, 0.8 * distance, 1e-9);
    zoom(camera, 1 / 0.8, point);
    EXPECT_NEAR(glm::distance(camera.target, glm::dvec3(3, -4, 5)), 0, 1e-9);
}

TEST_P(CameraControl, ZoomEndsAtItsLimits) {
    for (int i = 0; i < 500; ++i) {
        zoom(camera, 0.5, {1, 2, 3});
    }
    EXPECT_GT(camera.distance, 0);
    for (int i = 0; i < 500; ++i) {
        zoom(camera, 2, {1, 2, 3});
    }
    EXPECT_LT(camera.distance, 1e12);
}

TEST_P(CameraControl, OrbitTurnsAboutTheTargetAndKeepsZUpright) {
    const glm::dvec3 target = camera.target;
    const double distance = camera.distance;
    for (int i = 0; i < 100; ++i) {
        orbit(camera, {7, 5});
        EXPECT_EQ(camera.rotation.y, 0);
        const glm::dvec3 up = glm::dmat3(camera.eye_from_world()) * glm::dvec3(0, 0, 1);
        EXPECT_NEAR(up.x, 0, 1e-12);
        EXPECT_GE(up.y, -1e-12);
    }
    EXPECT_EQ(camera.target, target);
    EXPECT_EQ(camera.distance, distance);
    EXPECT_EQ(camera.rotation.x, 0);  // Dragged down long enough: seen from the top.
}

TEST_P(CameraControl, OrbitMovesTheNearSideWithTheCursor) {
    const glm::dvec3 near_side = camera.target + 0.05 * (camera.eye() - camera.target);
    const glm::dvec2 before = pixel_of(camera, near_side);
    orbit(camera, {20, 10});
    const glm::dvec2 after = pixel_of(camera, near_side);
    EXPECT_GT(after.x, before.x);
    EXPECT_GT(after.y, before.y);
}

TEST_P(CameraControl, ProjectionKeepsTheSizeAtTheTarget) {
    const glm::dvec3 point = point_on_target_plane(camera, kSize, {500, 100});
    const base::Projection before = camera.projection;
    toggle_projection(camera);
    EXPECT_NE(camera.projection, before);
    expect_near(pixel_of(camera, point), {500, 100});
}

TEST_P(CameraControl, ThePixelCameraSeesWhatIsUnderTheCursor) {
    const glm::dvec2 cursor{420.5, 99.5};
    const base::View::Ray wide = base::View(camera, kSize, glm::dvec3(-50), glm::dvec3(50)).ray(420, kSize.y - 100);
    const base::Camera narrow = pixel_camera(camera, kSize, cursor);
    const base::View::Ray ray = base::View(narrow, {1, 1}, glm::dvec3(-50), glm::dvec3(50)).ray(0, 0);
    EXPECT_NEAR(glm::length(glm::cross(glm::normalize(wide.direction), glm::normalize(ray.direction))), 0, 1e-9);
    EXPECT_NEAR(glm::length(glm::cross(ray.origin - wide.origin, glm::normalize(wide.direction))), 0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Both, CameraControl,
                         testing::Values(base::Projection::Perspective, base::Projection::Orthographic),
                         [](const auto& info) {
                             return info.param == base::Projection::Perspective ? "Perspective" : "Orthographic";
                         });

TEST(Orbit, ACameraUpsideDownTurnsFreely) {
    base::Camera camera;
    camera.rotation = {200, 0, 0};
    orbit(camera, {0, -10});
    EXPECT_NEAR(camera.rotation.x, 207, 1e-9);
}

TEST(CameraOption, IsWhatTheCommandLineTakes) {
    base::Camera camera;
    camera.target = {1, -2.5, 0};
    camera.rotation = {55, 0, 25};
    camera.distance = 140;
    EXPECT_EQ(camera_option(camera), "--camera 1,-2.5,0,55,0,25,140");
    camera.projection = base::Projection::Orthographic;
    EXPECT_EQ(camera_option(camera), "--camera 1,-2.5,0,55,0,25,140 --projection o");
}

TEST(CameraControl, SidesAreLookedAtUpright) {
    const auto from = [](const glm::dvec3& side) { return rotation_from(side, {55, 0, 100}); };
    EXPECT_EQ(from({0, -1, 0}), glm::dvec3(90, 0, 0)) << "front";
    EXPECT_EQ(from({1, 0, 0}), glm::dvec3(90, 0, 90)) << "right";
    EXPECT_EQ(from({0, 1, 0}), glm::dvec3(90, 0, 180)) << "back";
    EXPECT_EQ(from({-1, 0, 0}), glm::dvec3(90, 0, 270)) << "left";
    EXPECT_EQ(from({0, 0, 1}), glm::dvec3(0, 0, 90)) << "top, turned as it was about";
    EXPECT_EQ(from({0, 0, -1}), glm::dvec3(180, 0, 90)) << "bottom";
    base::Camera camera;
    camera.rotation = from({1, -1, 1});
    const glm::dvec3 to_eye = glm::normalize(camera.eye() - camera.target);
    EXPECT_LT(glm::distance(to_eye, glm::normalize(glm::dvec3(1, -1, 1))), 1e-12);
}

}  // namespace
}  // namespace ui
