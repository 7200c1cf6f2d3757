// Axis-aligned boxes.
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace csg {

/// An axis-aligned box, closed at both ends. A default box is empty and is the neutral element of `enclose`.
struct Box {
    glm::dvec3 lo{std::numeric_limits<double>::infinity()};
    glm::dvec3 hi{-std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
    [[nodiscard]] glm::dvec3 center() const { return 0.5 * (lo + hi); }
    [[nodiscard]] glm::dvec3 size() const { return empty() ? glm::dvec3(0.0) : hi - lo; }
    /// Length of the diagonal; 0 for an empty box.
    [[nodiscard]] double diagonal() const { return glm::length(size()); }
    bool operator==(const Box&) const = default;
};

/// The smallest box that holds `box` and `point`.
[[nodiscard]] inline Box enclose(const Box& box, const glm::dvec3& point) {
    return {glm::min(box.lo, point), glm::max(box.hi, point)};
}

/// The smallest box that holds both.
[[nodiscard]] inline Box enclose(const Box& a, const Box& b) {
    return {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

/// What both boxes share; empty where they are apart, flat where they only touch.
[[nodiscard]] inline Box intersect(const Box& a, const Box& b) {
    return {glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)};
}

/// True where the boxes share more than a face, an edge or a point: solids within them can share a volume.
[[nodiscard]] inline bool overlap(const Box& a, const Box& b) {
    return a.lo.x < b.hi.x && b.lo.x < a.hi.x && a.lo.y < b.hi.y && b.lo.y < a.hi.y && a.lo.z < b.hi.z &&
           b.lo.z < a.hi.z;
}

}  // namespace csg
