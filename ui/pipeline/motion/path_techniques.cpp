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

namespace {

/// Of the body's points the one that reaches farthest aside, and rather behind than ahead.
glm::dvec3 at_the_outline(const MovingBody& body, const glm::dmat4& pose, const glm::dvec3& aside,
                          const glm::dvec3& ahead) {
    const glm::dvec3* best = &body.extremes.front();
    double reach = -INFINITY;
    for (const glm::dvec3& p : body.extremes) {
        const glm::dvec3 placed(pose * glm::dvec4(p, 1));
        if (const double far = glm::dot(placed, aside - 0.3 * ahead); far > reach) {
            reach = far;
            best = &p;
        }
    }
    return *best;
}

/// The pieces of a way between its turning points, but for those shorter than `least`, and whether it leads back on
/// them: every other one, from the last.
std::vector<std::pair<bool, std::vector<glm::dvec3>>> by_direction(const std::vector<glm::dvec3>& way, double least) {
    std::vector<std::pair<bool, std::vector<glm::dvec3>>> pieces;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        if (i == 0 || glm::dot(way[i + 1] - way[i], way[i] - way[i - 1]) < 0) {
            pieces.push_back({!pieces.empty() && !pieces.back().first, {way[i]}});
        }
        pieces.back().second.push_back(way[i + 1]);
    }
    // Where a way ends at a turning point, samples may lead a little beyond it.
    std::erase_if(pieces, [&](const auto& piece) { return length_of(piece.second) < least; });
    const bool ahead = !pieces.empty() && pieces.back().first;
    for (auto& piece : pieces) {
        piece.first = piece.first != ahead;
    }
    return pieces;
}

}  // namespace

/// From points at the outline against the motion, the longer the faster it is, thinner and thinner; even strokes where
/// it swings back: against where it goes at the end, or against the others that it is depicted with.
void draw_trails(DepictionStage& stage, const DepictionTask& task, const Course& course) {
    const double from = task.from, to = task.to, radius = task.radius;
    const Depiction& d = task.what;
    const double h = 1e-3 * (stage.source.motion.times.back() - stage.source.motion.times.front());
    const auto here = course.at(to), before = course.at(to - h);
    if (!here || !before) {
        throw std::runtime_error(fmt::format("{} is not there at $t = {:.6g}", course.body().name, to));
    }
    const glm::dvec4 middle(middle_of(course.body()), 1);
    const glm::dvec3 velocity = glm::dvec3(*here * middle - *before * middle) / h;
    const glm::dvec3 against = velocity - stage.onward;
    constexpr double kBack = 0.05;
    const double onward = glm::dot(stage.onward, stage.onward);
    const bool swings_back = onward > 0 && glm::dot(against, stage.onward) < -kBack * onward;
    if (course.body().extremes.empty() || (!swings_back && h * glm::length(velocity) < 1e-9 * stage.size)) {
        throw std::runtime_error(fmt::format("{} is at rest at $t = {:.6g}", course.body().name, to));
    }
    const csg::Rgba color = d.color.value_or(kLines);
    const glm::dvec3 ahead = glm::normalize(swings_back ? against : velocity);
    const glm::dvec3 u = perpendicular(ahead), v = glm::cross(ahead, u);
    for (int k = 0; k < d.count; ++k) {
        const double angle = 2 * std::numbers::pi * k / d.count;
        const glm::dvec3 point = at_the_outline(course.body(), *here, std::cos(angle) * u + std::sin(angle) * v, ahead);
        if (swings_back) {
            // As it is seen by who goes along with the others, not quite up to the body.
            constexpr int kPoints = 16;
            constexpr double kFirst = 0.6, kLast = 0.12;
            std::vector<glm::dvec3> stroke;
            for (int i = 0; i <= kPoints; ++i) {
                const double time = to - (kFirst + (kLast - kFirst) * i / kPoints) * (to - from);
                if (const auto pose = course.at(time)) {
                    stroke.push_back(glm::dvec3(*pose * glm::dvec4(point, 1)) + (to - time) * stage.onward);
                }
            }
            if (length_of(stroke) > 2 * radius) {
                stage.add(plain_tube(stroke, 0.6 * radius), color);
            }
            continue;
        }
        for (const auto& part : course.way(point, from, to, kCurveStep * stage.size)) {
            for (const auto& [back, piece] : by_direction(part, 2 * radius)) {
                if (back) {
                    for (const auto& stroke : dashes(piece, 8 * radius, 6 * radius)) {
                        stage.add(plain_tube(stroke, 0.5 * radius), color);
                    }
                    continue;
                }
                std::vector<TubePoint> points;
                const double length = length_of(piece);
                double so_far = 0;
                for (std::size_t i = 0; i < piece.size(); ++i) {
                    so_far += i == 0 ? 0 : glm::distance(piece[i - 1], piece[i]);
                    points.push_back({piece[i], 0.8 * radius * so_far / length});
                }
                stage.add(tube(points), color);
            }
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
