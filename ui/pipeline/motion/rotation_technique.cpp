#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "ui/pipeline/motion/character.h"
#include "ui/pipeline/motion/techniques.h"
#include "ui/pipeline/motion/tube.h"

namespace ui {

glm::dvec3 perpendicular(const glm::dvec3& d) {
    return glm::normalize(glm::cross(d, std::abs(d.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0)));
}

/// Beyond its farthest reach, from there as far as it turns; with a head at either end where it turns back.
void draw_rotation(DepictionStage& stage, const DepictionTask& task, const MovingBody& body) {
    const double radius = task.radius;
    const csg::Rgba color = task.what.color.value_or(kGlyphColor);
    const Character c = character_of(stage.source.motion, body);
    if (c.kind != Character::Kind::Turns && c.kind != Character::Kind::Screws) {
        throw std::runtime_error(fmt::format("{} does not turn about one axis", body.name));
    }
    double reach = 0, low = INFINITY, high = -INFINITY;
    glm::dvec3 outwards = perpendicular(c.axis);
    for (const glm::dvec3& p : body.extremes) {
        const double along = glm::dot(p - c.point, c.axis);
        const glm::dvec3 aside = p - c.point - along * c.axis;
        low = std::min(low, along);
        high = std::max(high, along);
        if (glm::length(aside) > reach * (1 + 1e-9)) {
            reach = glm::length(aside);
            outwards = aside / reach;
        }
    }
    constexpr double kMost = 1.7 * std::numbers::pi;  // So that the ends of whole turns are apart.
    const bool back = c.turned_net < 0;
    double from = back ? c.turned_most : c.turned_least, to = back ? c.turned_least : c.turned_most;
    if (std::abs(to - from) > kMost) {
        to = from + std::copysign(kMost, to - from);
    }
    const glm::dvec3 aside = glm::cross(c.axis, outwards), middle = c.point + 0.5 * (low + high) * c.axis;
    const double r = 1.08 * reach + 3 * radius;
    const auto arc = [&](double first, double last) {
        std::vector<glm::dvec3> points;
        const int pieces = std::max(4, static_cast<int>(std::abs(last - first) / 0.06));
        for (int i = 0; i <= pieces; ++i) {
            const double a = first + (last - first) * i / pieces;
            points.push_back(middle + r * (std::cos(a) * outwards + std::sin(a) * aside));
        }
        return arrow(points, radius);
    };
    if (std::abs(c.turned_net) < 0.5 * (c.turned_most - c.turned_least)) {
        stage.add(arc(0.5 * (from + to), from), color);
        from = 0.5 * (from + to);
    }
    stage.add(arc(from, to), color);
}

}  // namespace ui
