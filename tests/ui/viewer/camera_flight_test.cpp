// Turns that are seen to happen.
#include "ui/viewer/camera_flight.h"

#include <gtest/gtest.h>

namespace ui {
namespace {

TEST(CameraFlight, TurnsTheShorterWayAndEndsWhereItIsToGo) {
    base::Camera camera;
    camera.rotation = {90, 0, 10};
    CameraFlight flight;
    flight.start(camera, {0, 0, 350}, 5);
    EXPECT_TRUE(flight.under_way());
    EXPECT_GT(camera.rotation.x, 0) << "the first step is done at once";
    double before = camera.rotation.x;
    for (double t = 5.05; t < 5.25; t += 0.05) {
        flight.advance(camera, t);
        EXPECT_GT(camera.rotation.x, before);
        EXPECT_GE(camera.rotation.z, 350);
        EXPECT_LE(camera.rotation.z, 370);
        before = camera.rotation.x;
    }
    flight.advance(camera, 6);
    EXPECT_EQ(camera.rotation, glm::dvec3(90, 0, 10));
    EXPECT_FALSE(flight.under_way());
}

TEST(CameraFlight, CanBeStoppedAndFinished) {
    base::Camera camera;
    camera.rotation = {90, 0, 0};
    CameraFlight flight;
    flight.start(camera, {0, 0, 0}, 0);
    const glm::dvec3 here = camera.rotation;
    flight.stop();
    flight.advance(camera, 9);
    EXPECT_EQ(camera.rotation, here);
    camera.rotation = {90, 0, 0};
    flight.start(camera, {0, 0, 0}, 0);
    flight.finish(camera);
    EXPECT_EQ(camera.rotation, glm::dvec3(90, 0, 0));
}

}  // namespace
}  // namespace ui
