// Object-space screen doors: how many samples are opaque, where they lie, and how surfaces at a slant look.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/npr/easel.h"

namespace {

using csg::Operation;
using scene::box;
using scene::colored;
using scene::Easel;
using scene::Model;

/// Black before a white background, seen from above, a unit a pixel: what is light is clear.
npr::Picture picture(int samples, int side = 64) {
    npr::Picture p;
    p.draw_as(*npr::find_style("shaded"));
    p.scheme = npr::color_schemes().front();
    p.scheme.background = p.scheme.background_stop = glm::vec3(1);
    p.camera.projection = base::Projection::Orthographic;
    p.camera.rotation = {0, 0, 0};
    p.camera.distance = 0.5 * side / std::tan(0.5 * p.camera.fov * std::acos(-1.0) / 180);
    p.size = {side, side};
    p.samples = samples;
    p.see_through_as(*npr::find_transparency("screen-door"));
    return p;
}

Model pane(float opacity, double side = 80) {
    return colored({0, 0, 0, opacity}, box({-0.5 * side, -0.5 * side, -1}, {side, side, 2}));
}

double opacity_of(const std::vector<glm::vec4>& light) {
    double sum = 0;
    for (const glm::vec4& pixel : light) {
        sum += 1 - pixel.r;
    }
    return sum / static_cast<double>(light.size());
}

TEST(ScreenDoor, OfEachMaskTheShareIsOpaque) {
    for (const float opacity : {0.0625F, 0.3F, 0.5F, 0.9F}) {
        const std::vector<glm::vec4> light = Easel(pane(opacity)).light(picture(1));
        const int expected = static_cast<int>(std::lround(256 * opacity));
        for (int mask = 0; mask < 16; ++mask) {
            int opaque = 0;
            for (int i = 0; i < 256; ++i) {
                const int x = 16 * (mask % 4) + i % 16, y = 16 * (mask / 4) + i / 16;
                opaque += light[static_cast<std::size_t>(y * 64 + x)].r < 0.5F ? 1 : 0;
            }
            EXPECT_EQ(opaque, expected) << "mask " << mask;
        }
    }
}

TEST(ScreenDoor, MoreSamplesMakeItSmooth) {
    double before = 1;
    for (const int samples : {4, 16, 64, 256}) {
        const std::vector<glm::vec4> light = Easel(pane(0.4F)).light(picture(samples));
        double squares = 0;
        for (const glm::vec4& pixel : light) {
            squares += (1 - pixel.r - 0.4) * (1 - pixel.r - 0.4);
        }
        const double noise = std::sqrt(squares / static_cast<double>(light.size()));
        EXPECT_NEAR(opacity_of(light), 0.4, 0.01);
        EXPECT_LT(noise, 0.6 * before) << samples;
        before = noise;
    }
    EXPECT_LT(before, 0.02) << "16 by 16";
}

/// A surface of which 1 / n_z samples lie behind each of the picture's.
TEST(ScreenDoor, SurfacesAtASlantAreMoreOpaque) {
    for (const float opacity : {0.2F, 0.5F}) {
        Easel easel(pane(opacity, 600));
        for (const double degrees : {0.0, 30.0, 50.0, 60.0, 70.0, 78.0}) {
            npr::Picture p = picture(16, 24);
            p.camera.rotation = {degrees, 0, 20};
            const double facing = std::cos(degrees * std::acos(-1.0) / 180);
            EXPECT_NEAR(opacity_of(easel.light(p)), 1 - std::pow(1 - opacity, 1 / facing), 0.02) << degrees;
            p.transparency_parameters.read("silhouettes", "off");
            EXPECT_NEAR(opacity_of(easel.light(p)), opacity, 0.02) << degrees;
        }
    }
}

TEST(ScreenDoor, MasksMoveWithTheSurface) {
    Easel easel(pane(0.5F, 200));
    npr::Picture p = picture(1);
    const std::vector<glm::vec4> before = easel.light(p);
    p.camera.target = {5, -3, 0};
    const std::vector<glm::vec4> after = easel.light(p);
    int changed = 0, same_place = 0;
    for (int y = 3; y < 60; ++y) {
        for (int x = 5; x < 58; ++x) {
            const auto at = [](int px, int py) { return static_cast<std::size_t>(py * 64 + px); };
            changed += before[at(x, y)].r != after[at(x - 5, y + 3)].r ? 1 : 0;
            same_place += before[at(x, y)].r != after[at(x, y)].r ? 1 : 0;
        }
    }
    EXPECT_LE(changed, 3) << "up to rounding";
    EXPECT_GT(same_place, 1000);
}

TEST(ScreenDoor, SamplesAreAsLargeAsThoseOfThePicture) {
    // From twice as far away the same pane shows samples twice as large: as many as before behind each pixel.
    Easel easel(pane(0.5F, 400));
    const auto runs = [&](double closer) {
        npr::Picture p = picture(1);
        p.camera.distance /= closer;
        const std::vector<glm::vec4> light = easel.light(p);
        int changes = 0;
        for (std::size_t i = 1; i < light.size(); ++i) {
            changes += light[i].r != light[i - 1].r ? 1 : 0;
        }
        return changes;
    };
    EXPECT_NEAR(runs(1), runs(2), 200);
    EXPECT_NEAR(runs(1), runs(0.25), 200);
    EXPECT_NEAR(runs(1), 2048, 200);
}

/// Masks of two panes are not the same: the one behind shows through the other as through any.
TEST(ScreenDoor, LayersMultiply) {
    const Model behind = colored({0, 0, 0, 0.5F}, box({-40, -40, -9}, {80, 80, 2}));
    const Model two = scene::combine(Operation::Union, {pane(0.5F), behind});
    EXPECT_NEAR(opacity_of(Easel(two).light(picture(16))), 0.75, 0.01);
}

}  // namespace
