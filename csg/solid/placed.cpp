#include "csg/solid/placed.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "base/stop.h"
#include "csg/solid/located.h"
#include "csg/solid/trim_leaves.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostOfAll = std::size_t{1} << 26;  // Triangles: some gigabytes.

bool affine(const glm::dmat4& m) {
    for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 4; ++r) {
            if (!std::isfinite(m[c][r]))
                return false;
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

void place_leaf(const Tree& tree, const LeafInstance& instance, double flat, PlacedLeaf& leaf,
                std::vector<std::string>& warnings) {
    if (!affine(instance.to_world)) {
        warnings.push_back(
            located(tree, instance.where, "transformation is not finite or not affine; the object is left out"));
        return;
    }
    glm::dmat4 m = instance.to_world * (1.0 / instance.to_world[3][3]);
    if (leaf.solid->flat)
        stand_upright(m, flat);
    const double determinant = glm::determinant(glm::dmat3(m));
    if (leaf.solid->triangles.empty() || determinant == 0 || !std::isfinite(determinant))
        return;
    leaf.points.reserve(leaf.solid->points.size());
    for (const glm::dvec3& p : leaf.solid->points) {
        leaf.points.emplace_back(m * glm::dvec4(p, 1.0));
        leaf.box = enclose(leaf.box, leaf.points.back());
    }
    // A closed mesh without volume is nothing; an open one is seen, however it lies.
    const glm::dvec3 size = leaf.box.size();
    const bool nothing = leaf.solid->closed && !(size.x > 0 && size.y > 0 && size.z > 0);
    if (nothing || !std::isfinite(size.x + size.y + size.z)) {
        leaf.points.clear();
        leaf.box = {};
        return;
    }
    leaf.triangles = leaf.solid->triangles;
    if (determinant < 0) {
        for (glm::uvec3& t : leaf.triangles)
            std::swap(t.y, t.z);
    }
}

/// Logarithm of the smallest height, quantised: how well a triangle's plane is known.
int accuracy(const PlacedLeaf& leaf, const glm::uvec3& t) {
    const glm::dvec3 &a = leaf.points[t.x], &b = leaf.points[t.y], &c = leaf.points[t.z];
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    const double height = glm::length(glm::cross(b - a, c - a)) / longest;
    return height > 0 && std::isfinite(height) ? std::ilogb(height) : -2000;
}

/// The widest triangles first, so that an entry of the table is as accurate as can be.
void assign_planes(Geometry& geometry, const std::stop_token& stop) {
    struct Item {
        int accuracy;
        std::uint32_t leaf, triangle;
    };
    std::vector<Item> items;
    for (std::uint32_t l = 0; l < geometry.leaves.size(); ++l) {
        base::end_if_asked(stop);
        PlacedLeaf& leaf = geometry.leaves[l];
        leaf.planes.resize(leaf.triangles.size());
        for (std::uint32_t t = 0; t < leaf.triangles.size(); ++t)
            items.push_back({accuracy(leaf, leaf.triangles[t]), l, t});
    }
    std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.accuracy > b.accuracy; });
    base::PacedStop paced(stop);
    for (const Item& item : items) {
        paced();
        PlacedLeaf& leaf = geometry.leaves[item.leaf];
        const glm::uvec3& t = leaf.triangles[item.triangle];
        leaf.planes[item.triangle] = geometry.planes.add(leaf.points[t.x], leaf.points[t.y], leaf.points[t.z]);
    }
}

}  // namespace

Geometry place(const Tree& tree, const Scene& scene, SolidCache& cache, double flat, const std::stop_token& stop) {
    Geometry geometry;
    const std::vector<Dimension> by_node = dimensions(tree);
    geometry.leaves.resize(scene.leaves.size());
    // All are counted before any is placed, which takes most of the memory.
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < scene.leaves.size(); ++i) {
        base::end_if_asked(stop);
        PlacedLeaf& leaf = geometry.leaves[i];
        leaf.solid = cache.get(tree, scene.leaves[i].node, by_node, geometry.warnings, stop);
        if ((triangles += leaf.solid->triangles.size()) > kMostOfAll)
            throw GeometryError(fmt::format("the model has more than {} triangles", kMostOfAll));
    }
    for (std::size_t i = 0; i < scene.leaves.size(); ++i) {
        base::end_if_asked(stop);
        place_leaf(tree, scene.leaves[i], flat, geometry.leaves[i], geometry.warnings);
    }
    trim_leaves(scene, geometry.leaves);
    double largest = 0;
    for (const PlacedLeaf& leaf : geometry.leaves) {
        if (leaf.box.empty())
            continue;
        geometry.box = enclose(geometry.box, leaf.box);
        for (int axis = 0; axis < 3; ++axis)
            largest = std::max({largest, std::abs(leaf.box.lo[axis]), std::abs(leaf.box.hi[axis])});
    }
    // An object that occurs twice is told once.
    std::vector<std::string> once;
    for (std::string& warning : geometry.warnings) {
        if (std::find(once.begin(), once.end(), warning) == once.end())
            once.push_back(std::move(warning));
    }
    geometry.warnings = std::move(once);
    geometry.planes = PlaneTable(coincidence_tolerance(largest));
    assign_planes(geometry, stop);
    return geometry;
}

}  // namespace csg::solid
