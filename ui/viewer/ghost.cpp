#include "ui/viewer/ghost.h"

#include <algorithm>
#include <map>

namespace ui {

namespace {

constexpr double kSmooth = 0.87;  // Cosine between the normals of facets that are one surface.

void add(const csg::solid::PlacedLeaf& leaf, Ghost& ghost) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, glm::dvec3> half;  // Normals at edges of which one side is known.
    for (const glm::uvec3& triangle : leaf.triangles) {
        const std::array<glm::dvec3, 3> corners{leaf.points[triangle.x], leaf.points[triangle.y],
                                                leaf.points[triangle.z]};
        ghost.triangles.push_back(corners);
        const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(across);
        const glm::dvec3 normal = length > 0 ? across / length : glm::dvec3(0);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
            const auto [known, added] = half.try_emplace(std::minmax(from, to), normal);
            if (!added) {
                if (glm::dot(known->second, normal) < kSmooth) {
                    ghost.creases.emplace_back(leaf.points[from], leaf.points[to]);
                }
                half.erase(known);
            }
        }
    }
}

/// Whether one of the operations above takes it away.
bool is_cutter(const Model& model, csg::OccurrenceId occurrence) {
    bool cuts = false;
    const csg::Scene& scene = model.scene;
    for (csg::OccurrenceId id = occurrence; scene.occurrences[id].parent != csg::kNoOccurrence;
         id = scene.occurrences[id].parent) {
        const csg::Node& above = model.tree->node(scene.occurrences[scene.occurrences[id].parent].node);
        cuts = cuts != (above.operation == csg::Operation::Difference && scene.occurrences[id].child > 0);
    }
    return cuts;
}

}  // namespace

Ghost ghost_of(const Model& model, csg::OccurrenceId occurrence, std::size_t most) {
    Ghost ghost;
    if (occurrence >= model.scene.occurrences.size()) {
        return ghost;
    }
    ghost.cuts = is_cutter(model, occurrence);
    for (csg::LeafId leaf = 0; leaf < model.scene.leaves.size(); ++leaf) {
        csg::OccurrenceId id = model.scene.leaves[leaf].occurrence;
        while (id != csg::kNoOccurrence && id > occurrence) {
            id = model.scene.occurrences[id].parent;  // Parents stand before.
        }
        if (id != occurrence) {
            continue;
        }
        if (ghost.triangles.size() + model.geometry.leaves[leaf].triangles.size() > most) {
            return {};
        }
        add(model.geometry.leaves[leaf], ghost);
    }
    return ghost;
}

}  // namespace ui
