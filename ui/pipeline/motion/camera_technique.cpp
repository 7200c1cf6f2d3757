#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "ui/pipeline/motion/techniques.h"
#include "ui/pipeline/motion/tube.h"

namespace ui {

namespace {

/// What a camera sees: its eye, and the corners of the picture where it looks.
struct Shot {
    glm::dvec3 eye{0.0};
    std::array<glm::dvec3, 4> corners;  ///< One after the other.

    Shot(const base::Camera& camera, double aspect) : eye(camera.eye()) {
        const glm::dmat3 to_world = glm::transpose(glm::dmat3(camera.eye_from_world()));
        const double half = camera.distance * std::tan(0.5 * camera.fov * std::numbers::pi / 180);
        constexpr std::array<glm::dvec2, 4> kAround{glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            corners[i] = camera.target + half * (to_world * glm::dvec3(kAround[i].x * aspect, kAround[i].y, 0));
        }
    }
};

double way_of(const std::vector<Shot>& shots) {
    double way = 0;
    for (std::size_t i = 0; i + 1 < shots.size(); ++i) {
        way = std::max(way, glm::distance(shots[i].eye, shots[i + 1].eye));
        for (std::size_t k = 0; k < 4; ++k) {
            way = std::max(way, glm::distance(shots[i].corners[k], shots[i + 1].corners[k]));
        }
    }
    return way;
}

/// A frame of bars, with their ends in each other.
void add_frame(DepictionStage& stage, const Shot& shot, double radius, const csg::Rgba& color) {
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 &a = shot.corners[i], &b = shot.corners[(i + 1) % 4];
        const glm::dvec3 along = radius * glm::normalize(b - a);
        const glm::dvec3 bar[]{a - along, b + along};
        stage.add(plain_tube(bar, radius), color);
    }
}

}  // namespace

/// The first and the last picture as frames where the camera looks, arrows from corner to corner, the way of the eye,
/// and small pyramids where it is (figure 7-8).
void draw_camera(DepictionStage& stage, const DepictionTask& task) {
    constexpr csg::Rgba kShot{0.15F, 0.35F, 0.75F, 1};
    constexpr int kCurve = 33;
    const csg::Rgba color = task.what.color.value_or(kShot);
    std::vector<Shot> shots;
    shots.reserve(kCurve);
    for (int i = 0; i < kCurve; ++i) {
        shots.emplace_back(stage.source.camera_at(task.from + (task.to - task.from) * i / (kCurve - 1)),
                           stage.source.aspect);
    }
    const double size = std::max(stage.size, glm::distance(shots.front().corners[0], shots.front().corners[2]));
    if (!(way_of(shots) > 1e-9 * size)) {
        throw std::runtime_error("the camera stays where it is: $vpr, $vpt and $vpd do not depend on $t");
    }
    constexpr double kOfSize = 0.003;
    const double radius = task.what.width ? 0.5 * *task.what.width : kOfSize * size;
    add_frame(stage, shots.front(), 1.4 * radius, color);
    add_frame(stage, shots.back(), 1.4 * radius, color);
    const auto add_way = [&](const auto& point_of) {
        std::vector<glm::dvec3> way;
        for (const Shot& shot : shots) {
            if (const glm::dvec3 p = point_of(shot); way.empty() || glm::distance(way.back(), p) > 1e-6 * size) {
                way.push_back(p);
            }
        }
        if (way.size() > 1 && length_of(way) > 4 * radius) {
            stage.add(arrow(way, radius), color);
        }
    };
    for (std::size_t k = 0; k < 4; ++k) {
        add_way([k](const Shot& shot) { return shot.corners[k]; });
    }
    add_way([](const Shot& shot) { return shot.eye; });
    // Pyramids on the way, with the eye at their tips.
    constexpr double kPyramid = 0.12;
    const int count = std::max(2, std::min(task.what.count, kCurve));
    for (int i = 0; i < count; ++i) {
        const Shot& shot = shots[static_cast<std::size_t>(i * (kCurve - 1) / (count - 1))];
        csg::Polyhedron pyramid;
        pyramid.points.push_back(shot.eye);
        for (const glm::dvec3& corner : shot.corners) {
            pyramid.points.push_back(shot.eye + kPyramid * (corner - shot.eye));
        }
        pyramid.faces = {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}, {1, 2, 3, 4}};
        stage.add(std::move(pyramid), color);
    }
}

}  // namespace ui
