#include "csg/reference/open_leaves.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "csg/reference/expression_value.h"
#include "csg/reference/point_ids.h"

namespace csg::reference {
namespace {

bool is_open(const solid::PlacedLeaf& leaf) {
    if (leaf.solid->closed)
        return false;
    PointIds points;
    std::vector<std::uint32_t> ids;
    for (const glm::dvec3& p : leaf.points)
        ids.push_back(points.add(p).first);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const glm::uvec3& t : leaf.triangles) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = ids[t[k]], b = ids[t[(k + 1) % 3]];
            if (a != b)
                edges.emplace_back(std::min(a, b), std::max(a, b));
        }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0, j; i < edges.size(); i = j) {
        for (j = i + 1; j < edges.size() && edges[j] == edges[i]; ++j) {
        }
        if ((j - i) % 2 != 0)
            return true;
    }
    return false;
}

/// Is a node that holds the leaf more than a union of it with others?
bool only_united(const Scene& scene, LeafId leaf) {
    for (const PartId id : solid_parts(scene)) {
        const Part& part = scene.parts[id];
        if (leaf < part.first_leaf || leaf >= part.first_leaf + part.leaf_count)
            continue;
        std::vector<char> holds(part.root - part.first_expression + 1, 0);
        for (std::uint32_t i = part.first_expression; i <= part.root; ++i) {
            const Expression& e = scene.expressions[i];
            char& held = holds[i - part.first_expression];
            held = e.kind == ExpressionKind::Leaf && e.leaf == leaf ? 1 : 0;
            for (const std::uint32_t child : scene.children(e))
                held = held != 0 || holds[child - part.first_expression] != 0 ? 1 : 0;
            if (held != 0 && e.kind != ExpressionKind::Leaf && e.kind != ExpressionKind::Union && e.child_count > 1)
                return false;
        }
    }
    return true;
}

}  // namespace

std::vector<LeafId> open_leaves(const solid::Geometry& geometry, std::span<const LeafId> leaves) {
    std::vector<LeafId> result;
    std::copy_if(leaves.begin(), leaves.end(), std::back_inserter(result),
                 [&](LeafId leaf) { return is_open(geometry.leaves[leaf]); });
    return result;
}

bool stands_apart(const Scene& scene, const solid::Geometry& geometry, std::span<const LeafId> leaves, LeafId leaf) {
    return only_united(scene, leaf) && std::none_of(leaves.begin(), leaves.end(), [&](LeafId other) {
               return other != leaf && overlap(geometry.leaves[leaf].box, geometry.leaves[other].box);
           });
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
