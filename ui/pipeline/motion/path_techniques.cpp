#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "ui/pipeline/motion/techniques.h"
#include "ui/pipeline/motion/tube.h"

namespace ui {

namespace {

constexpr csg::Rgba kLines{0.25F, 0.25F, 0.3F, 1};

}  // namespace

void draw_path(DepictionStage& stage, const DepictionTask& task, const Course& course) {
    const double from = task.from, to = task.to, radius = task.radius;
    const csg::Rgba color = task.what.color.value_or(kGlyphColor);
    const glm::dvec3 middle = middle_of(course.body());
    bool drawn = false;
    for (const bool future : {false, true}) {
        const double first = future ? std::max(from, stage.source.now) : from,
                     last = future ? to : std::min(to, stage.source.now);
        if (!(first < last)) {
            continue;
        }
        for (const auto& part : course.way(middle, first, last, kCurveStep * stage.size)) {
            if (length_of(part) < 2 * radius) {
                continue;
            }
            drawn = true;
            if (!future) {
                stage.add(last < to ? plain_tube(part, radius) : arrow(part, radius), color);
                continue;
            }
            const auto pieces = dashes(part, 8 * radius, 5 * radius);
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                stage.add(i + 1 < pieces.size() ? plain_tube(pieces[i], radius) : arrow(pieces[i], radius), color);
            }
        }
    }
    if (!drawn) {
        throw std::runtime_error(
            fmt::format("the middle of {} stays where it is; rotation shows what turns", course.body().name));
    }
}

/// From points at the outline against the motion, the longer the faster it is, thinner and thinner.
void draw_trails(DepictionStage& stage, const DepictionTask& task, const Course& course) {
    const double from = task.from, to = task.to, radius = task.radius;
    const Depiction& d = task.what;
    const double h = 1e-3 * (stage.source.motion.times.back() - stage.source.motion.times.front());
    const auto here = course.at(to), before = course.at(to - h);
    if (!here || !before) {
        throw std::runtime_error(fmt::format("{} is not there at $t = {:.6g}", course.body().name, to));
    }
    const std::vector<glm::dvec3>& extremes = course.body().extremes;
    const glm::dvec4 middle(middle_of(course.body()), 1);
    const glm::dvec3 velocity(*here * middle - *before * middle);
    if (extremes.empty() || glm::length(velocity) < 1e-9 * stage.size) {
        throw std::runtime_error(fmt::format("{} is at rest at $t = {:.6g}", course.body().name, to));
    }
    const glm::dvec3 ahead = glm::normalize(velocity);
    const glm::dvec3 u = perpendicular(ahead), v = glm::cross(ahead, u);
    for (int k = 0; k < d.count; ++k) {
        const double angle = 2 * std::numbers::pi * k / d.count;
        const glm::dvec3 aside = std::cos(angle) * u + std::sin(angle) * v;
        const glm::dvec3* best = &extremes.front();
        double reach = -INFINITY;
        for (const glm::dvec3& p : extremes) {
            const glm::dvec3 placed(*here * glm::dvec4(p, 1));
            if (const double far = glm::dot(placed, aside - 0.3 * ahead); far > reach) {
                reach = far;
                best = &p;
            }
        }
        for (const auto& part : course.way(*best, from, to, kCurveStep * stage.size)) {
            std::vector<TubePoint> points;
            const double length = length_of(part);
            double so_far = 0;
            for (std::size_t i = 0; i < part.size(); ++i) {
                so_far += i == 0 ? 0 : glm::distance(part[i - 1], part[i]);
                points.push_back({part[i], 0.8 * radius * so_far / length});
            }
            stage.add(tube(points), d.color.value_or(kLines));
        }
    }
}

csg::Polyhedron plain_tube(std::span<const glm::dvec3> curve, double radius) {
    std::vector<TubePoint> points;
    for (const glm::dvec3& p : curve) {
        points.push_back({p, radius});
    }
    return tube(points);
}

}  // namespace ui
