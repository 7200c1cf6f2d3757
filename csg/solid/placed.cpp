#include "csg/solid/placed.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "base/stop.h"
#include "csg/solid/located.h"
#include "csg/solid/trim_leaves.h"
#include "csg/tree/finite.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostOfAll = std::size_t{1} << 26;  // Triangles: some gigabytes.
/// Floats hold them, doubles their products.
constexpr double kLargestCoordinate = 1e30;

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

bool has_volume(const Box& box) {
    const glm::dvec3 size = box.size();
    return size.x > 0 && size.y > 0 && size.z > 0;
}

double largest_coordinate(const Box& box) {
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis)
        largest = std::max({largest, std::abs(box.lo[axis]), std::abs(box.hi[axis])});
    return largest;
}

void leave_out(PlacedLeaf& leaf) {
    leaf.points.clear();
    leaf.triangles.clear();
    leaf.box = {};
}

/// Leaves the leaf empty where it cannot be placed. The failure, where it should not be so.
std::string place_leaf(const LeafInstance& instance, double flat, PlacedLeaf& leaf) {
    if (!affine(instance.to_world))
        return "transformation is not finite or not affine; the object is left out";
    glm::dmat4 m = instance.to_world * (1.0 / instance.to_world[3][3]);
    if (leaf.solid->flat)
        stand_upright(m, flat);
    const double determinant = glm::determinant(glm::dmat3(m));
    if (leaf.solid->triangles.empty() || determinant == 0)
        return {};
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
        for (glm::uvec3& t : leaf.triangles)
            std::swap(t.y, t.z);
    }
    return {};
}

/// What is wrong with the size of a leaf by itself, for the user; empty where nothing is.
std::string fault_of_size(const PlacedLeaf& leaf, double largest) {
    if (leaf.solid->closed && !has_volume(leaf.box) && has_volume(leaf.solid->box))
        return fmt::format(
            "this object is left out: beside coordinates as large as {:.3g} it is too thin for double precision",
            largest);
    if (largest > kLargestCoordinate)
        return fmt::format("this object is left out: its coordinates reach {:.3g}, and {:.3g} is the most", largest,
                           kLargestCoordinate);
    return {};
}

/// All that is decided by the size of leaves, once they are trimmed. Leaves out what has no volume (of closed meshes:
/// an open one is seen, however it lies) or is larger than can be worked with; where that should not be so it is a
/// failure. What is too thin beside the largest coordinate for its faces to be told apart has a mesh, by exact
/// arithmetic, but no picture. Gives that coordinate.
double judge_sizes(const Tree& tree, const Scene& scene, std::span<PlacedLeaf> leaves, Remarks& remarks) {
    double largest = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        if (leaves[i].box.empty())
            continue;
        const double own = largest_coordinate(leaves[i].box);
        const std::string fault = fault_of_size(leaves[i], own);
        if (!fault.empty())
            remarks.failures.push_back(located(tree, scene.leaves[i].where, fault));
        if (!fault.empty() || (leaves[i].solid->closed && !has_volume(leaves[i].box)))
            leave_out(leaves[i]);
        else
            largest = std::max(largest, own);
    }
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const glm::dvec3 size = leaves[i].box.size();
        if (!leaves[i].box.empty() && leaves[i].solid->closed && !leaves[i].solid->flat &&
            std::min({size.x, size.y, size.z}) <= coincidence_tolerance(largest))
            remarks.warnings.push_back(located(
                tree, scene.leaves[i].where,
                fmt::format("no picture shows this object: it is too thin beside coordinates as large as {:.3g}",
                            largest)));
    }
    return largest;
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
    std::size_t count = 0;
    for (const PlacedLeaf& leaf : geometry.leaves)
        count += leaf.triangles.size();
    std::vector<Item> items;
    items.reserve(count);
    std::map<int, std::uint32_t, std::greater<>>
        place;  // Of the next item of this accuracy; first, how many there are.
    for (std::uint32_t l = 0; l < geometry.leaves.size(); ++l) {
        base::end_if_asked(stop);
        PlacedLeaf& leaf = geometry.leaves[l];
        leaf.planes.resize(leaf.triangles.size());
        for (std::uint32_t t = 0; t < leaf.triangles.size(); ++t) {
            items.push_back({accuracy(leaf, leaf.triangles[t]), l, t});
            ++place[items.back().accuracy];
        }
    }
    std::uint32_t next = 0;
    for (auto& [accuracy, at] : place)
        at = std::exchange(next, next + at);
    base::PacedStop paced(stop);
    std::vector<std::uint32_t> order(items.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        paced();
        order[place[items[i].accuracy]++] = i;
    }
    for (const std::uint32_t i : order) {
        paced();
        const Item& item = items[i];
        PlacedLeaf& leaf = geometry.leaves[item.leaf];
        const glm::uvec3& t = leaf.triangles[item.triangle];
        leaf.planes[item.triangle] = geometry.planes.add(leaf.points[t.x], leaf.points[t.y], leaf.points[t.z]);
    }
}

/// An object that occurs twice is told once.
std::vector<std::string> once(std::vector<std::string> texts) {
    std::unordered_set<std::string> told;
    std::erase_if(texts, [&](const std::string& text) { return !told.insert(text).second; });
    return texts;
}

}  // namespace

Geometry place(const Tree& tree, const Scene& scene, SolidCache& cache, double flat, const std::stop_token& stop) {
    Geometry geometry;
    Remarks remarks;
    const std::vector<Dimension> by_node = dimensions(tree);
    geometry.leaves.resize(scene.leaves.size());
    // All are counted before any is placed, which takes most of the memory.
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < scene.leaves.size(); ++i) {
        base::end_if_asked(stop);
        PlacedLeaf& leaf = geometry.leaves[i];
        leaf.solid = cache.get(tree, scene.leaves[i].node, by_node, remarks, stop);
        if ((triangles += leaf.solid->triangles.size()) > kMostOfAll)
            throw GeometryError(fmt::format("the model has more than {} triangles", kMostOfAll));
    }
    for (std::size_t i = 0; i < scene.leaves.size(); ++i) {
        base::end_if_asked(stop);
        const LeafInstance& instance = scene.leaves[i];
        if (const std::string failure = place_leaf(instance, flat, geometry.leaves[i]); !failure.empty())
            remarks.failures.push_back(located(tree, instance.where, failure));
    }
    trim_leaves(scene, geometry.leaves);
    const double largest = judge_sizes(tree, scene, geometry.leaves, remarks);
    for (const PlacedLeaf& leaf : geometry.leaves) {
        if (!leaf.box.empty())
            geometry.box = enclose(geometry.box, leaf.box);
    }
    geometry.warnings = once(std::move(remarks.warnings));
    geometry.failures = once(std::move(remarks.failures));
    geometry.planes = PlaneTable(coincidence_tolerance(largest));
    assign_planes(geometry, stop);
    return geometry;
}

}  // namespace csg::solid
