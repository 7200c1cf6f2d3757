#include "csg/solid/placed.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "base/stop.h"
#include "csg/solid/assign_planes.h"
#include "csg/solid/located.h"
#include "csg/solid/place_leaf.h"
#include "csg/solid/trim_leaves.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostOfAll = std::size_t{1} << 26;  // Triangles: some gigabytes.

/// All that is decided by the size of leaves, once they are trimmed. Leaves out what has no volume (of closed meshes:
/// an open one is seen, however it lies) or is larger than can be worked with; where that should not be so it is a
/// failure. What is too thin beside the largest coordinate for its faces to be told apart has a mesh, by exact
/// arithmetic, but no picture. Gives that coordinate.
double judge_sizes(const Tree& tree, const Scene& scene, std::span<PlacedLeaf> leaves, Remarks& remarks) {
    double largest = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        if (leaves[i].box.empty()) {
            continue;
        }
        const double own = largest_coordinate(leaves[i].box);
        const std::string fault = fault_of_size(leaves[i], own);
        if (!fault.empty()) {
            remarks.failures.push_back(located(tree, scene.leaves[i].where, fault));
        }
        if (!fault.empty() || (leaves[i].solid->closed && !has_volume(leaves[i].box))) {
            leave_out(leaves[i]);
        } else {
            largest = std::max(largest, own);
        }
    }
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const glm::dvec3 size = leaves[i].box.size();
        if (!leaves[i].box.empty() && leaves[i].solid->closed && !leaves[i].solid->flat &&
            std::min({size.x, size.y, size.z}) <= coincidence_tolerance(largest)) {
            remarks.warnings.push_back(located(
                tree, scene.leaves[i].where,
                fmt::format("no picture shows this object: it is too thin beside coordinates as large as {:.3g}",
                            largest)));
        }
    }
    return largest;
}

/// An object that occurs twice is told once.
std::vector<std::string> once(std::vector<std::string> texts) {
    std::unordered_set<std::string> told;
    std::erase_if(texts, [&](const std::string& text) { return !told.insert(text).second; });
    return texts;
}

}  // namespace

std::span<const FacetGroup> groups_of(const PlacedLeaf& leaf) {
    const auto fits = [&](const std::vector<FacetGroup>& groups) { return groups.size() == leaf.triangles.size(); };
    if (fits(leaf.groups)) {
        return leaf.groups;
    }
    return leaf.solid && fits(leaf.solid->groups) ? std::span(leaf.solid->groups) : std::span<const FacetGroup>();
}

Geometry place(const Tree& tree, const Scene& scene, SolidCache& cache, double flat, const std::stop_token& stop,
               const Room& room) {
    Geometry geometry;
    geometry.flat = flat;
    Remarks remarks;
    const std::vector<Dimension> by_node = dimensions(tree);
    geometry.leaves.resize(scene.leaves.size());
    // All are counted before any is placed, which takes most of the memory.
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < scene.leaves.size(); ++i) {
        base::end_if_asked(stop);
        PlacedLeaf& leaf = geometry.leaves[i];
        leaf.solid = cache.get(tree, scene.leaves[i].node, by_node, remarks, stop);
        if ((triangles += leaf.solid->triangles.size()) > kMostOfAll) {
            throw GeometryError(fmt::format("the model has more than {} triangles", kMostOfAll));
        }
    }
    for (std::size_t i = 0; i < scene.leaves.size(); ++i) {
        base::end_if_asked(stop);
        const LeafInstance& instance = scene.leaves[i];
        if (const std::string failure = place_leaf(instance, flat, geometry.leaves[i]); !failure.empty()) {
            remarks.failures.push_back(located(tree, instance.where, failure));
        }
    }
    cache.tell_left_out(tree, scene, by_node, remarks, stop);
    trim_leaves(scene, geometry.leaves);
    const double largest = judge_sizes(tree, scene, geometry.leaves, remarks);
    for (const PlacedLeaf& leaf : geometry.leaves) {
        if (!leaf.box.empty()) {
            geometry.box = enclose(geometry.box, leaf.box);
        }
    }
    geometry.warnings = once(std::move(remarks.warnings));
    geometry.failures = once(std::move(remarks.failures));
    geometry.center = room.center_for(geometry.box);
    geometry.planes = PlaneTable(coincidence_tolerance(room.reach_for(largest)));
    assign_planes(geometry, stop);
    return geometry;
}

}  // namespace csg::solid
