#include "ui/pipeline/picture/camera.h"

#include <gtest/gtest.h>

namespace ui {
namespace {

const csg::Box kBox{{0, 0, 0}, {10, 20, 30}};

TEST(ChooseCamera, WithoutAnyEverythingIsInView) {
    const base::Camera camera = choose_camera({}, {}, kBox);
    EXPECT_EQ(camera.target, kBox.center());
    EXPECT_EQ(camera.rotation, base::Camera{}.rotation);
    EXPECT_GT(camera.distance, kBox.diagonal());
}

TEST(ChooseCamera, TheFilesVariablesCount) {
    csg::scad::ViewSettings file;
    file.translation = {1, 2, 3};
    file.rotation = {10, 20, 30};
    file.distance = 77;
    file.fov = 30;
    const base::Camera camera = choose_camera({}, file, kBox);
    EXPECT_EQ(camera.target, glm::dvec3(1, 2, 3));
    EXPECT_EQ(camera.rotation, glm::dvec3(10, 20, 30));
    EXPECT_EQ(camera.distance, 77);
    EXPECT_EQ(camera.fov, 30);
}

TEST(ChooseCamera, ImpossibleVariablesAreAsIfNotGiven) {
    csg::scad::ViewSettings file;
    file.distance = -1;
    file.fov = 180;
    const base::Camera camera = choose_camera({}, file, kBox);
    EXPECT_EQ(camera.distance, base::Camera{}.distance);
    EXPECT_EQ(camera.fov, base::Camera{}.fov);
}

TEST(ChooseCamera, TheUsersCameraWinsAndViewAllMovesIt) {
    csg::scad::ViewSettings file;
    file.distance = 77;
    base::Camera mine;
    mine.target = {5, 5, 5};
    mine.distance = 9;
    CameraRequest request{mine, base::Projection::Orthographic, false, false};
    EXPECT_EQ(choose_camera(request, file, kBox).distance, 9);
    EXPECT_EQ(choose_camera(request, file, kBox).projection, base::Projection::Orthographic);
    request.view_all = true;
    EXPECT_GT(choose_camera(request, file, kBox).distance, kBox.diagonal());
    EXPECT_EQ(choose_camera(request, file, kBox).target, mine.target);
    request.autocenter = true;
    EXPECT_EQ(choose_camera(request, file, kBox).target, kBox.center());
}

TEST(ChooseCamera, AnEmptyBoxMovesNothing) {
    base::Camera mine;
    mine.target = {5, 5, 5};
    EXPECT_EQ(choose_camera({mine, base::Projection::Perspective, false, true}, {}, {}).target, mine.target);
}

TEST(ScadView, AnglesBelowZeroAreTurnedUp) {
    base::Camera camera;
    camera.target = {1, -2, 3};
    camera.rotation = {-30, 20, 0};
    camera.distance = 7;
    camera.fov = 40;
    const csg::scad::View view = scad_view(camera);
    EXPECT_EQ(view.rotation, (std::array<double, 3>{330, 20, 0}));
    EXPECT_EQ(view.translation, (std::array<double, 3>{1, -2, 3}));
    EXPECT_EQ(view.distance, 7);
    EXPECT_EQ(view.fov, 40);
}

}  // namespace
}  // namespace ui
