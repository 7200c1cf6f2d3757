#include "ui/viewer/tools/turn_rings.h"

#include <cmath>
#include <numbers>

#include "ui/viewer/picture_places.h"

namespace ui {

namespace {

constexpr double kRingRadius = 80, kRingReach = 8;  // Units of the window.
constexpr int kRingCorners = 72;
constexpr double kEdgeOn = 0.05;  // Cosine between the line of sight and the axis: nothing can be turned by it.

/// The two axes that a third is turned from and to, counter-clockwise.
std::pair<int, int> across(std::size_t axis) {
    const int i = static_cast<int>(axis);
    return {(i + 1) % 3, (i + 2) % 3};
}

}  // namespace

TurnRings::TurnRings(const base::Camera& camera, const Rectangle& picture, const glm::dvec3& pivot, float scale)
    : camera_(camera),
      picture_(picture),
      pivot_(pivot),
      radius_(kRingRadius * static_cast<double>(scale) * unit_at(camera, picture, pivot)),
      reach_(kRingReach * static_cast<double>(scale)) {}

std::vector<TurnRings::Corner> TurnRings::ring(std::size_t axis) const {
    const auto middle = place_of(camera_, picture_, pivot_);
    if (!middle) {
        return {};
    }
    const glm::dvec3 to_pivot = sight(camera_, picture_, *middle).direction;
    const auto [u, v] = across(axis);
    std::vector<Corner> corners;
    for (int i = 0; i < kRingCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kRingCorners;
        glm::dvec3 arm(0.0);
        arm[u] = radius_ * std::cos(angle);
        arm[v] = radius_ * std::sin(angle);
        const auto at = place_of(camera_, picture_, pivot_ + arm);
        if (!at) {
            return {};
        }
        corners.push_back({*at, glm::dot(arm, to_pivot) > 1e-6 * radius_ * glm::length(to_pivot)});
    }
    return corners;
}

std::optional<std::size_t> TurnRings::axis_at(const glm::dvec2& at) const {
    for (const bool behind : {false, true}) {
        std::optional<std::size_t> nearest;
        double least = reach_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::vector<Corner> corners = ring(axis);
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const Corner& next = corners[(i + 1) % corners.size()];
                const double away = distance_to_segment(at, corners[i].at, next.at);
                if (corners[i].behind == behind && away < least && angle_at(axis, at)) {
                    least = away;
                    nearest = axis;
                }
            }
        }
        if (nearest) {
            return nearest;
        }
    }
    return std::nullopt;
}

std::optional<double> TurnRings::angle_at(std::size_t axis, const glm::dvec2& at) const {
    const base::View::Ray ray = sight(camera_, picture_, at);
    const glm::dvec3 direction = glm::normalize(ray.direction);
    const int normal = static_cast<int>(axis);
    if (std::abs(direction[normal]) < kEdgeOn) {
        return std::nullopt;
    }
    const glm::dvec3 met = ray.origin + direction * ((pivot_ - ray.origin)[normal] / direction[normal]) - pivot_;
    const auto [u, v] = across(axis);
    return glm::degrees(std::atan2(met[v], met[u]));
}

}  // namespace ui
