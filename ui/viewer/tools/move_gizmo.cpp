#include "ui/viewer/tools/move_gizmo.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "ui/viewer/picture_places.h"

namespace ui {

namespace {

constexpr double kArmLength = 90, kNearby = 8;  // Units of the window, as are:
constexpr double kInner = 0.3, kOuter = 0.52;   // Shares of an arm that a square lies between.
constexpr double kHole = 0.16;                  // Of the arm, where the middle is.
constexpr double kLeastArrow = 14, kLeastCosine = 0.12;

bool inside(const std::array<glm::dvec2, 4>& corners, const glm::dvec2& at) {
    int left = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 side = corners[(i + 1) % 4] - corners[i], to = at - corners[i];
        left += side.x * to.y - side.y * to.x > 0 ? 1 : -1;
    }
    return std::abs(left) == 4;
}

glm::dvec3 axis(std::size_t i) {
    glm::dvec3 direction(0);
    direction[static_cast<int>(i)] = 1;
    return direction;
}

/// That which a plane of two axes does not move along.
std::size_t normal_axis(MoveHandle plane) {
    return static_cast<std::size_t>(plane) - static_cast<std::size_t>(MoveHandle::YZ);
}

}  // namespace

std::array<bool, 3> axes_of(MoveHandle handle) {
    std::array<bool, 3> moves{true, true, true};
    if (handle < MoveHandle::YZ) {
        moves = {};
        moves[static_cast<std::size_t>(handle)] = true;
    } else if (handle != MoveHandle::Free) {
        moves[normal_axis(handle)] = false;
    }
    return moves;
}

MoveGizmo::MoveGizmo(const base::Camera& camera, const Rectangle& picture, const glm::dvec3& center, float scale)
    : camera_(camera),
      picture_(picture),
      center_(center),
      unit_(unit_at(camera, picture, center)),
      arm_(kArmLength * static_cast<double>(scale) * unit_),
      reach_(kNearby * static_cast<double>(scale)) {}

std::optional<glm::dvec2> MoveGizmo::place(const glm::dvec3& from_center) const {
    return place_of(camera_, picture_, center_ + from_center);
}

std::optional<glm::dvec2> MoveGizmo::tip(MoveHandle handle) const {
    const auto from = middle(), to = place(arm_ * axis(static_cast<std::size_t>(handle)));
    return from && to && glm::distance(*from, *to) >= kLeastArrow ? to : std::nullopt;
}

std::optional<std::array<glm::dvec2, 4>> MoveGizmo::square(MoveHandle plane) const {
    const std::size_t normal = normal_axis(plane);
    const auto from = middle();
    const glm::dvec3 sight_line = from ? sight(camera_, picture_, *from).direction : glm::dvec3(0);
    if (!from || std::abs(glm::normalize(sight_line)[static_cast<int>(normal)]) < kLeastCosine) {
        return std::nullopt;
    }
    const glm::dvec3 u = arm_ * axis((normal + 1) % 3), v = arm_ * axis((normal + 2) % 3);
    std::array<glm::dvec2, 4> corners;
    const std::array<glm::dvec2, 4> shares{{{kInner, kInner}, {kOuter, kInner}, {kOuter, kOuter}, {kInner, kOuter}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto corner = place(shares[i].x * u + shares[i].y * v);
        if (!corner) {
            return std::nullopt;
        }
        corners[i] = *corner;
    }
    return corners;
}

std::optional<MoveHandle> MoveGizmo::handle_at(const glm::dvec2& at) const {
    const auto from = middle();
    if (!from) {
        return std::nullopt;
    }
    if (glm::distance(*from, at) <= 1.2 * reach_) {
        return MoveHandle::Free;
    }
    for (const MoveHandle plane : {MoveHandle::YZ, MoveHandle::ZX, MoveHandle::XY}) {
        if (const auto corners = square(plane); corners && inside(*corners, at)) {
            return plane;
        }
    }
    std::optional<MoveHandle> nearest;
    double least = reach_;
    for (const MoveHandle handle : {MoveHandle::X, MoveHandle::Y, MoveHandle::Z}) {
        const auto to = tip(handle);
        const double away = to ? distance_to_segment(at, glm::mix(*from, *to, kHole), *to) : least;
        if (away < least) {
            nearest = handle;
            least = away;
        }
    }
    return nearest;
}

std::optional<glm::dvec3> MoveGizmo::grip(MoveHandle handle, const glm::dvec2& at) const {
    const base::View::Ray ray = sight(camera_, picture_, at);
    const glm::dvec3 direction = glm::normalize(ray.direction), between = center_ - ray.origin;
    if (handle < MoveHandle::YZ) {
        const glm::dvec3 along = axis(static_cast<std::size_t>(handle));
        const double cosine = glm::dot(direction, along), square_of_sine = 1 - cosine * cosine;
        if (square_of_sine < 1e-4) {
            return std::nullopt;
        }
        return (cosine * glm::dot(direction, between) - glm::dot(along, between)) / square_of_sine * along;
    }
    const glm::dvec3 normal = handle == MoveHandle::Free
                                  ? glm::transpose(glm::dmat3(camera_.eye_from_world())) * glm::dvec3(0, 0, 1)
                                  : axis(normal_axis(handle));
    const double cosine = glm::dot(direction, normal);
    if (std::abs(cosine) < 1e-3) {
        return std::nullopt;
    }
    return direction * (glm::dot(between, normal) / cosine) - between;
}

glm::dvec3 in_steps(const glm::dvec3& by, MoveHandle handle, double step) {
    const std::array<bool, 3> moves = axes_of(handle);
    glm::dvec3 rounded(0);
    for (int i = 0; i < 3; ++i) {
        rounded[i] = moves[static_cast<std::size_t>(i)] ? std::round(by[i] / step) * step : 0;
    }
    return rounded;
}

glm::dvec3 typed_way(const std::string& typed, MoveHandle handle, const glm::dvec3& by) {
    const std::array<bool, 3> moves = axes_of(handle);
    glm::dvec3 way = by;
    const char* at = typed.c_str();
    for (int i = 0; i < 3 && *at != '\0'; ++i) {
        if (!moves[static_cast<std::size_t>(i)]) {
            continue;
        }
        char* end = nullptr;
        const double value = std::strtod(at, &end);
        way[i] = end != at ? value : way[i];
        at = end;
        while (*at != '\0' && *at++ != ',') {
        }
    }
    return way;
}

}  // namespace ui
