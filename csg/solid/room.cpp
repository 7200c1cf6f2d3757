#include "csg/solid/room.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace csg::solid {
namespace {

/// The least power of two that is not less.
double power_of_two(double x) {
    return std::exp2(std::ceil(std::log2(x)));
}

}  // namespace

double Room::reach_for(double largest) const {
    if (reach == 0) {
        return largest;
    }
    return largest <= reach ? reach : power_of_two(largest);
}

std::optional<glm::dvec3> Room::center_for(const Box& scene) const {
    if (box.empty() || scene.empty()) {
        return {};
    }
    const double margin = box.diagonal();
    if (enclose(scene, {box.lo - margin, box.hi + margin}) == Box{box.lo - margin, box.hi + margin}) {
        return box.center();
    }
    const double cell = power_of_two(scene.diagonal());
    return glm::round(scene.center() / cell) * cell;
}

Box Room::around(const Box& bounded) const {
    const double margin = std::max(box.diagonal() / 8, std::numeric_limits<double>::min());
    const Box usual{box.lo - margin, box.hi + margin};
    // Strictly within, or faces would coincide.
    const double least = margin / 4;
    if (bounded.empty() || enclose(usual, {bounded.lo - least, bounded.hi + least}) == usual) {
        return usual;
    }
    const double cell = power_of_two(bounded.diagonal()) / 4;
    return {(glm::floor(bounded.lo / cell) - 1.0) * cell, (glm::ceil(bounded.hi / cell) + 1.0) * cell};
}

}  // namespace csg::solid
