#include "csg/solid/place_leaf.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "csg/tree/finite.h"

namespace csg::solid {
namespace {

/// Floats hold them, doubles their products.
constexpr double kLargestCoordinate = 1e30;

bool affine(const glm::dmat4& m) {
    for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 4; ++r) {
            if (!std::isfinite(m[c][r])) {
                return false;
            }
        }
    }
    return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] != 0;
}

/// Gives a matrix for outlines a third column of length `flat` across the first two.
void stand_upright(glm::dmat4& m, double flat) {
    const glm::dvec3 across = glm::cross(glm::dvec3(m[0]), glm::dvec3(m[1]));
    const double length = glm::length(across);
    m[2] = length > 0 && std::isfinite(length) ? glm::dvec4(across * (flat / length), 0.0) : glm::dvec4(0.0);
}

}  // namespace

bool has_volume(const Box& box) {
    const glm::dvec3 size = box.size();
    return size.x > 0 && size.y > 0 && size.z > 0;
}

double largest_coordinate(const Box& box) {
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        largest = std::max({largest, std::abs(box.lo[axis]), std::abs(box.hi[axis])});
    }
    return largest;
}

void leave_out(PlacedLeaf& leaf) {
    leaf.points.clear();
    leaf.triangles.clear();
    leaf.groups.clear();
    leaf.face_triangles = 0;
    leaf.box = {};
}

std::string place_leaf(const LeafInstance& instance, double flat, PlacedLeaf& leaf) {
    if (!affine(instance.to_world)) {
        return "transformation is not finite or not affine; the object is left out";
    }
    glm::dmat4 m = instance.to_world * (1.0 / instance.to_world[3][3]);
    if (leaf.solid->flat) {
        stand_upright(m, flat);
    }
    const double determinant = glm::determinant(glm::dmat3(m));
    if (leaf.solid->triangles.empty() || determinant == 0) {
        return {};
    }
    leaf.points.reserve(leaf.solid->points.size());
    bool finite = std::isfinite(determinant);
    for (const glm::dvec3& p : leaf.solid->points) {
        leaf.points.emplace_back(m * glm::dvec4(p, 1.0));
        finite = finite && is_finite(leaf.points.back());
        leaf.box = enclose(leaf.box, leaf.points.back());
    }
    if (!finite || !std::isfinite(2 * largest_coordinate(leaf.box))) {
        leave_out(leaf);
        return "this object is left out: its coordinates are too large for double precision";
    }
    leaf.triangles = leaf.solid->triangles;
    if (determinant < 0) {
        for (glm::uvec3& t : leaf.triangles) {
            std::swap(t.y, t.z);
        }
    }
    return {};
}

std::string fault_of_size(const PlacedLeaf& leaf, double largest) {
    if (leaf.solid->closed && !has_volume(leaf.box) && has_volume(leaf.solid->box)) {
        return fmt::format(
            "this object is left out: beside coordinates as large as {:.3g} it is too thin for double precision",
            largest);
    }
    if (largest > kLargestCoordinate) {
        return fmt::format("this object is left out: its coordinates reach {:.3g}, and {:.3g} is the most", largest,
                           kLargestCoordinate);
    }
    return {};
}

}  // namespace csg::solid
