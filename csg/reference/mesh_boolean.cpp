#include "csg/reference/mesh_boolean.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "csg/solid/mesh_checks.h"

namespace csg::reference {

MeshScene make_mesh_scene(ExpressionKind operation, std::span<const Mesh> operands) {
    MeshScene result;
    auto& [scene, geometry] = result;
    const auto count = static_cast<std::uint32_t>(operands.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        auto shape = std::make_shared<solid::Solid>();
        shape->points = operands[i].points;
        shape->triangles = operands[i].triangles;
        solid::check_mesh(*shape);
        solid::PlacedLeaf leaf;
        leaf.solid = std::move(shape);
        leaf.points = operands[i].points;
        leaf.triangles = operands[i].triangles;
        for (const glm::dvec3& p : leaf.points) {
            leaf.box = enclose(leaf.box, p);
        }
        geometry.box = enclose(geometry.box, leaf.box);
        geometry.leaves.push_back(std::move(leaf));
        scene.leaves.emplace_back();
        Expression e;
        e.leaf = i;
        scene.expressions.push_back(e);
        scene.expression_children.push_back(i);
    }
    Expression all;
    all.kind = operation;
    all.child_count = count;
    scene.expressions.push_back(all);
    if (count > 0) {
        scene.parts.push_back({PartKind::Solid, 0, count, 0, count, "", {}});
    }
    geometry.planes = solid::PlaneTable(solid::coincidence_tolerance(largest_coordinate(operands)));
    for (solid::PlacedLeaf& leaf : geometry.leaves) {
        for (const glm::uvec3& t : leaf.triangles) {
            leaf.planes.push_back(geometry.planes.add(leaf.points[t.x], leaf.points[t.y], leaf.points[t.z]));
        }
    }
    return result;
}

BooleanResult combine(ExpressionKind operation, std::span<const Mesh> operands, const std::stop_token& stop) {
    const MeshScene made = make_mesh_scene(operation, operands);
    return make_mesh(made.scene, made.geometry, {.method = {}, .stop = stop});
}

}  // namespace csg::reference
