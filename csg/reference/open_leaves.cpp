#include "csg/reference/open_leaves.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "csg/reference/box_pairs.h"
#include "csg/reference/expression_value.h"
#include "csg/reference/point_ids.h"

namespace csg::reference {
namespace {

bool is_open(const solid::PlacedLeaf& leaf) {
    if (leaf.solid->closed) {
        return false;
    }
    PointIds points;
    std::vector<std::uint32_t> ids;
    for (const glm::dvec3& p : leaf.points) {
        ids.push_back(points.add(p).first);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const glm::uvec3& t : leaf.triangles) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = ids[t[k]], b = ids[t[(k + 1) % 3]];
            if (a != b) {
                edges.emplace_back(std::min(a, b), std::max(a, b));
            }
        }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0, j; i < edges.size(); i = j) {
        for (j = i + 1; j < edges.size() && edges[j] == edges[i]; ++j) {
        }
        if ((j - i) % 2 != 0) {
            return true;
        }
    }
    return false;
}

/// By leaf: is every node that holds it a union?
std::vector<char> only_united(const Scene& scene) {
    std::vector<char> united(scene.expressions.size(), 0), result(scene.leaves.size(), 0);
    for (const PartId id : solid_parts(scene)) {
        const Part& part = scene.parts[id];
        united[part.root] = 1;
        for (std::uint32_t i = part.root + 1; i-- > part.first_expression;) {
            const Expression& e = scene.expressions[i];
            if (e.kind == ExpressionKind::Leaf) {
                result[e.leaf] = united[i];
            }
            const bool alone = e.kind == ExpressionKind::Union || e.child_count == 1;
            for (const std::uint32_t child : scene.children(e)) {
                united[child] = alone ? united[i] : 0;
            }
        }
    }
    return result;
}

}  // namespace

std::vector<LeafId> open_leaves(const solid::Geometry& geometry, std::span<const LeafId> leaves) {
    std::vector<LeafId> result;
    std::copy_if(leaves.begin(), leaves.end(), std::back_inserter(result),
                 [&](LeafId leaf) { return is_open(geometry.leaves[leaf]); });
    return result;
}

std::optional<LeafId> find_combined(const Scene& scene, const solid::Geometry& geometry, std::span<const LeafId> leaves,
                                    std::span<const LeafId> open) {
    const std::vector<char> united = only_united(scene);
    std::vector<Box> boxes;
    boxes.reserve(leaves.size());
    for (const LeafId leaf : leaves) {
        boxes.push_back(geometry.leaves[leaf].box);
    }
    const BoxTree tree(boxes);
    for (const LeafId leaf : open) {
        const Box& box = geometry.leaves[leaf].box;
        bool met = united[leaf] == 0;
        tree.meeting(box, [&](std::uint32_t i) { met |= leaves[i] != leaf && overlap(box, boxes[i]); });
        if (met) {
            return leaf;
        }
    }
    return {};
}

void append_leaf(Mesh& mesh, const solid::PlacedLeaf& placed, LeafId leaf) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), placed.points.begin(), placed.points.end());
    for (const glm::uvec3& t : placed.triangles) {
        mesh.triangles.push_back(t + first);
        mesh.sources.push_back(leaf);
    }
}

}  // namespace csg::reference
