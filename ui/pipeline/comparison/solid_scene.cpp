#include "ui/pipeline/comparison/solid_scene.h"

namespace ui {

SolidScene solid_scene(const csg::Scene& scene, const csg::solid::Geometry& geometry) {
    SolidScene result;
    result.geometry.planes = geometry.planes;
    csg::Scene& to = result.scene;
    to.occurrences = scene.occurrences;
    std::vector<std::uint32_t> roots;
    for (const csg::Part& part : scene.parts) {
        if (part.kind != csg::PartKind::Solid && part.kind != csg::PartKind::Translucent) {
            continue;
        }
        const auto leaf_shift = static_cast<std::uint32_t>(to.leaves.size()) - part.first_leaf;
        const auto shift = static_cast<std::uint32_t>(to.expressions.size()) - part.first_expression;
        for (csg::LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
            to.leaves.push_back(scene.leaves[leaf]);
            to.leaves.back().part = 0;
            result.geometry.leaves.push_back(geometry.leaves[leaf]);
            result.geometry.box = csg::enclose(result.geometry.box, geometry.leaves[leaf].box);
        }
        for (std::uint32_t i = part.first_expression; i <= part.root; ++i) {
            csg::Expression e = scene.expressions[i];
            const auto children = scene.children(e);
            e.leaf += leaf_shift;
            e.first_child = static_cast<std::uint32_t>(to.expression_children.size());
            for (const std::uint32_t child : children) {
                to.expression_children.push_back(child + shift);
            }
            to.expressions.push_back(e);
        }
        roots.push_back(part.root + shift);
    }
    if (roots.empty()) {
        return result;
    }
    if (roots.size() > 1) {
        csg::Expression all;
        all.kind = csg::ExpressionKind::Union;
        all.first_child = static_cast<std::uint32_t>(to.expression_children.size());
        all.child_count = static_cast<std::uint32_t>(roots.size());
        to.expression_children.insert(to.expression_children.end(), roots.begin(), roots.end());
        to.expressions.push_back(all);
    }
    to.parts.push_back({csg::PartKind::Solid,
                        0,
                        static_cast<std::uint32_t>(to.expressions.size() - 1),
                        0,
                        static_cast<csg::LeafId>(to.leaves.size()),
                        "model",
                        {}});
    return result;
}

}  // namespace ui
