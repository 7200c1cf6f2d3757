#include "base/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using base::Camera;
using base::View;

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
    EXPECT_LE(glm::length(a - b), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

Camera looking(glm::dvec3 rotation, base::Projection projection) {
    Camera c;
    c.rotation = rotation;
    c.target = {1, 2, 3};
    c.distance = 50;
    c.projection = projection;
    return c;
}

TEST(Camera, LooksDownZWithoutRotation) {
    expect_near(looking({0, 0, 0}, base::Projection::Perspective).eye(), {1, 2, 53}, 1e-12);
}

TEST(Camera, FrontViewLooksAlongY) {
    // OpenSCAD's front view is $vpr = [90, 0, 0]: the eye stands at -y.
    expect_near(looking({90, 0, 0}, base::Projection::Perspective).eye(), {1, -48, 3}, 1e-12);
}

TEST(Camera, BetweenPointsKeepsBoth) {
    for (const glm::dvec3 eye : {glm::dvec3(10, 20, 30), glm::dvec3(-5, 1, -7), glm::dvec3(0, 0, 9)}) {
        const glm::dvec3 center(1, -2, 0.5);
        const Camera c = base::camera_between(eye, center);
        expect_near(c.eye(), eye, 1e-9);
        expect_near(c.target, center, 0);
    }
}

TEST(Camera, ViewAllHoldsTheSphereAboutTheBox) {
    Camera c;
    base::view_all(c, {-1, -2, -3}, {5, 6, 7}, true);
    expect_near(c.target, {2, 2, 2}, 0);
    EXPECT_NEAR(c.distance * std::sin(c.fov / 2 * M_PI / 180), std::sqrt(36 + 64 + 100) / 2, 1e-9);
}

TEST(Camera, ViewTightTouchesTheMargins) {
    const glm::dvec3 lo(-1, -2, -3), hi(5, 6, 7);
    for (const auto projection : {base::Projection::Orthographic, base::Projection::Perspective}) {
        for (const glm::ivec2 size : {glm::ivec2(400, 300), glm::ivec2(200, 500)}) {
            for (const bool center : {true, false}) {
                Camera c;
                c.projection = projection;
                c.target = {9, 9, 9};
                base::view_tight(c, lo, hi, static_cast<double>(size.x) / size.y, 0.05, center);
                const View view(c, size, lo, hi);
                glm::dvec2 least(1e9), most(-1e9);
                for (int i = 0; i < 8; ++i) {
                    const glm::dvec4 clip =
                        view.clip_from_world() *
                        glm::dvec4(i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z, 1);
                    least = glm::min(least, glm::dvec2(clip) / clip.w);
                    most = glm::max(most, glm::dvec2(clip) / clip.w);
                }
                const glm::dvec2 reach = glm::max(-least, most);
                EXPECT_NEAR(std::max(reach.x, reach.y), 0.9, 1e-9);
                if (center) {
                    EXPECT_NEAR(std::max(-least.x, -least.y), 0.9, 1e-9);
                    EXPECT_NEAR(std::max(most.x, most.y), 0.9, 1e-9);
                } else {
                    expect_near(c.target, {9, 9, 9}, 0);
                }
            }
        }
    }
}

class ViewTest : public testing::TestWithParam<base::Projection> {};

/// The depth of a plane, its point on the ray and the projection of that point must tell the same story.
TEST_P(ViewTest, PlaneDepthAgreesWithTheRay) {
    const View view(looking({35, 10, 70}, GetParam()), {320, 200}, {-10, -10, -10}, {10, 12, 14}, {0.2, -0.3});
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
    const double offset = 2.5;
    const View::PlaneDepth d = view.plane_depth(normal, offset);
    ASSERT_FALSE(d.edge_on);
    for (int y = 0; y < 200; y += 37) {
        for (int x = 0; x < 320; x += 41) {
            const View::Ray ray = view.ray(x, y);
            const double t = (offset - glm::dot(normal, ray.origin)) / glm::dot(normal, ray.direction);
            const double depth = d.a * (x + 0.5 - 160) + d.b * (y + 0.5 - 100) + d.c;
            EXPECT_NEAR(depth, view.depth(t), 1e-6);
            EXPECT_NEAR(view.distance(view.depth(t)), t, 1e-9 * std::abs(t));
            const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(ray.origin + t * ray.direction, 1.0);
            EXPECT_NEAR((clip.x / clip.w + 1) * 160, x + 0.5, 1e-9);  // the jittered sample lands on the pixel's center
            EXPECT_NEAR((clip.y / clip.w + 1) * 100, y + 0.5, 1e-9);
            EXPECT_NEAR(clip.z / clip.w, view.depth(t), 1e-12);
        }
    }
}

TEST_P(ViewTest, DepthIsReversedAndEnclosesTheBox) {
    const View view(looking({55, 0, 25}, GetParam()), {64, 64}, {-10, -10, -10}, {10, 10, 10});
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 corner(i & 1 ? 10 : -10, i & 2 ? 10 : -10, i & 4 ? 10 : -10, 1);
        const double depth = view.depth(-(view.eye_from_world() * corner).z);
        EXPECT_GT(depth, 0.0);
        EXPECT_LT(depth, 1.0);
    }
    EXPECT_GT(view.depth(view.near_distance() + 1), view.depth(view.near_distance() + 2));
}

TEST_P(ViewTest, ScreenBoxHoldsTheProjection) {
    const View view(looking({55, 0, 25}, GetParam()), {200, 100}, {-10, -10, -10}, {10, 10, 10});
    const View::Rectangle r = view.screen_box({-2, -2, -2}, {3, 4, 5});
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(i & 1 ? 3 : -2, i & 2 ? 4 : -2, i & 4 ? 5 : -2, 1);
        const double x = (clip.x / clip.w + 1) * 100, y = (clip.y / clip.w + 1) * 50;
        EXPECT_TRUE(r.x0 <= x && x <= r.x1 && r.y0 <= y && y <= r.y1) << x << ' ' << y;
    }
    EXPECT_TRUE(view.screen_box({500, 500, 0}, {501, 501, 1}).empty());
}

INSTANTIATE_TEST_SUITE_P(Projections, ViewTest,
                         testing::Values(base::Projection::Perspective, base::Projection::Orthographic));

TEST(View, AnEyeInsideTheBoxKeepsPrecision) {
    Camera c;
    c.distance = 1e-3;
    const View view(c, {64, 64}, {-10, -10, -10}, {10, 10, 10});
    EXPECT_GT(view.near_distance(), 0.0);
    EXPECT_LT(view.near_distance(), 1e-3);
    // Two surfaces 1e-4 apart at distance 10 differ in 32-bit depth.
    EXPECT_NE(static_cast<float>(view.depth(10.0)), static_cast<float>(view.depth(10.0001)));
}

TEST(View, AnEyeInsideAnEndlessBoxSeesWhatItLooksAt) {
    Camera c;
    c.distance = 140;
    const View view(c, {64, 64}, glm::dvec3(-5e9), glm::dvec3(5e9));
    EXPECT_LT(view.near_distance(), 1);
    EXPECT_GT(static_cast<float>(view.depth(1e10)), 0.0F);
}

}  // namespace
