// Screen doors, measured: the curve of opacity against the normal beside Crow's formula, and the flicker of a turntable
// beside masks in image space and hashed alpha. Prints the tables of docs/transparency/screen-door.md.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <random>

#include "tests/npr/easel.h"

namespace {

using scene::Easel;

constexpr double kDegree = 0.017453292519943295;

npr::Picture picture(int samples, int side) {
    npr::Picture p;
    p.draw_as(*npr::find_style("shaded"));
    p.scheme = npr::color_schemes().front();
    p.scheme.background = p.scheme.background_stop = glm::vec3(1);
    p.camera.projection = base::Projection::Orthographic;
    p.camera.distance = 0.5 * side / std::tan(0.5 * p.camera.fov * kDegree);
    p.size = {side, side};
    p.samples = samples;
    p.see_through_as(*npr::find_transparency("screen-door"));
    return p;
}

void print_curve(float opacity, int side) {
    Easel easel(scene::colored({0, 0, 0, opacity}, scene::box({-2000, -2000, -1}, {4000, 4000, 2})));
    fmt::print(
        "| N_z | 1 − (1 − α)^(1 / N_z) | picture | Crow, p = 2 | Crow, p = 3 |\n| --- | --- | --- | --- | --- |\n");
    for (const double facing : {1.0, 0.9, 0.8, 0.6, 0.4, 0.3, 0.2, 0.1}) {
        npr::Picture p = picture(16, side);
        p.camera.rotation = {std::acos(facing) / kDegree, 0, 25};
        double sum = 0;
        const std::vector<glm::vec4> light = easel.light(p);
        for (const glm::vec4& pixel : light) {
            sum += 1 - pixel.r;
        }
        // Transparency from 1 - opacity, toward the eye, to 0.
        const auto crow = [&](double power) { return 1 - (1 - opacity) * (1 - std::pow(1 - facing, power)); };
        fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", facing, 1 - std::pow(1 - opacity, 1 / facing),
                   sum / static_cast<double>(light.size()), crow(2), crow(3));
    }
}

/// Is what a point of a ball, given in the ball's coordinates, is seen in opaque?
using Mask = std::function<bool(int frame, glm::ivec2 pixel, const glm::dvec3& point)>;

double uniform(glm::ivec3 at, std::uint32_t key) {
    std::uint32_t h = key;
    for (int i = 0; i < 3; ++i) {
        h = (h ^ static_cast<std::uint32_t>(at[i])) * 0x9e3779b1U;
        h ^= h >> 15U;
        h *= 0x85ebca77U;
        h ^= h >> 13U;
    }
    return (h >> 8U) / 16777216.0;
}

/// Wyman and McGuire 2017, with the coordinates' change from pixel to pixel: two sizes of cells, in powers of two,
/// mixed and made uniform again.
double hashed(const glm::dvec3& point, double change) {
    const double level = std::log2(1 / change);
    const double low = std::exp2(std::floor(level)), high = std::exp2(std::ceil(level));
    const double a = uniform(glm::floor(low * point), 1), b = uniform(glm::floor(high * point), 1);
    const double part = level - std::floor(level), x = (1 - part) * a + part * b, least = std::min(part, 1 - part);
    if (least <= 0) {
        return x;
    }
    return x < least       ? x * x / (2 * least * (1 - least))
           : x < 1 - least ? (x - 0.5 * least) / (1 - least)
                           : 1 - (1 - x) * (1 - x) / (2 * least * (1 - least));
}

/// A ball turns before the eye. How many of the points on it change from opaque to clear, or back, in a frame: 1 is as
/// many as would by chance.
double flicker(const std::vector<glm::dmat3>& frames, double radius, int side, double opacity, const Mask& mask) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    std::size_t changes = 0, chances = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::dvec3 point = radius * glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        std::optional<bool> before;
        for (std::size_t frame = 0; frame < frames.size(); ++frame) {
            const glm::dvec3 seen = frames[frame] * point;
            if (seen.z < 0.3 * radius) {
                before.reset();
                continue;
            }
            const glm::ivec2 pixel(glm::floor(glm::dvec2(seen) + 0.5 * side));
            const bool now = mask(static_cast<int>(frame), pixel, point);
            chances += before ? 1 : 0;
            changes += before && *before != now ? 1 : 0;
            before = now;
        }
    }
    return static_cast<double>(changes) / static_cast<double>(chances) / (2 * opacity * (1 - opacity));
}

void print_flicker(int side, int frame_count) {
    constexpr float kOpacity = 0.5F;
    const double radius = 0.45 * side;
    csg::Fineness fine;
    fine.fn = 200;
    Easel easel(scene::colored({0, 0, 0, kOpacity}, scene::leaf(csg::Sphere{radius, fine})));
    std::vector<glm::dmat3> frames;
    using Pictures = std::vector<std::vector<glm::vec4>>;
    Pictures drawn, coarse;
    for (int frame = 0; frame < frame_count; ++frame) {
        npr::Picture p = picture(1, side);
        p.camera.rotation = {70, 0, 25.0 + frame};
        frames.emplace_back(p.camera.eye_from_world());
        drawn.push_back(easel.light(p));
        p.transparency_parameters.read("size", "2");
        coarse.push_back(easel.light(p));
    }
    const auto at = [&](const Pictures& pictures, int frame, glm::ivec2 pixel) {
        return pictures[static_cast<std::size_t>(frame)][static_cast<std::size_t>(pixel.y * side + pixel.x)].r < 0.5F;
    };
    // Where the pixel's middle is on the ball, in the ball's coordinates.
    const auto on_ball = [&](int frame, glm::dvec2 pixel) {
        const glm::dvec2 xy = pixel + 0.5 - 0.5 * side;
        const glm::dvec3 seen(xy, std::sqrt(std::max(radius * radius - glm::dot(xy, xy), 0.0)));
        return glm::transpose(frames[static_cast<std::size_t>(frame)]) * seen;
    };
    const Mask doors = [&](int frame, glm::ivec2 pixel, const glm::dvec3&) { return at(drawn, frame, pixel); };
    const Mask coarse_doors = [&](int frame, glm::ivec2 pixel, const glm::dvec3&) { return at(coarse, frame, pixel); };
    const Mask image = [&](int, glm::ivec2 pixel, const glm::dvec3&) {
        return uniform({pixel.x & 15, pixel.y & 15, 0}, 1) < kOpacity;
    };
    const Mask alpha = [&](int frame, glm::ivec2 pixel, const glm::dvec3&) {
        const glm::dvec3 here = on_ball(frame, pixel);
        const double change = std::max(glm::length(on_ball(frame, glm::dvec2(pixel) + glm::dvec2(1, 0)) - here),
                                       glm::length(on_ball(frame, glm::dvec2(pixel) + glm::dvec2(0, 1)) - here));
        return hashed(here, change) < kOpacity;
    };
    fmt::print("| mask | flicker |\n| --- | --- |\n");
    fmt::print("| in object space: `screen-door` | {:.2f} |\n", flicker(frames, radius, side, kOpacity, doors));
    fmt::print("| the same with `size=2` | {:.2f} |\n", flicker(frames, radius, side, kOpacity, coarse_doors));
    fmt::print("| hashed alpha (Wyman and McGuire 2017) | {:.2f} |\n", flicker(frames, radius, side, kOpacity, alpha));
    fmt::print("| in image space, 16 × 16 | {:.2f} |\n", flicker(frames, radius, side, kOpacity, image));
}

}  // namespace

/// [SIDE FRAMES]: of the pictures, and how many of the turntable.
int main(int argc, char** argv) {
    const int side = argc > 1 ? std::stoi(argv[1]) : 256, frames = argc > 2 ? std::stoi(argv[2]) : 60;
    print_curve(0.3F, side);
    fmt::print("\n");
    print_flicker(side, frames);
    return 0;
}
