#include "ui/pipeline/mesh/outline.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

namespace ui {

namespace {

bool counts(const csg::Part& part) {
    return part.kind == csg::PartKind::Solid || part.kind == csg::PartKind::Translucent;
}

/// The first leaf of the model that is flat, and the first that is not; none where there are no such leaves.
std::array<std::optional<csg::LeafId>, 2> first_leaves(const Model& model) {
    std::array<std::optional<csg::LeafId>, 2> first;
    for (const csg::Part& part : model.scene.parts) {
        if (!counts(part)) {
            continue;
        }
        for (csg::LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
            const csg::solid::PlacedLeaf& placed = model.geometry.leaves[leaf];
            auto& known = first[placed.solid->flat ? 0 : 1];
            if (!placed.triangles.empty() && !known) {
                known = leaf;
            }
        }
    }
    return first;
}

/// A whole tree that is one leaf has no place: that of its first child is told.
std::string place_of(const Model& model, csg::LeafId leaf) {
    csg::SourceLocation where = model.scene.leaves[leaf].where;
    for (csg::NodeId node = model.scene.leaves[leaf].node; !where.known() && !model.tree->children(node).empty();) {
        node = model.tree->children(node)[0];
        where = model.tree->node(node).where;
    }
    const auto& files = model.tree->files();
    return where.known() && where.file < files.size()
               ? fmt::format("{}:{}:{}", files[where.file], where.line, where.column)
               : "an unknown place";
}

/// `other`: the extent that is refused.
void need(const Model& model, Extent wanted, const char* refused) {
    const Extent extent = extent_of(model);
    if (extent == wanted) {
        return;
    }
    if (extent == Extent::None) {
        throw ModelError("the model is empty: there is nothing to export");
    }
    const auto [flat, solid] = first_leaves(model);
    if (extent == Extent::Mixed) {
        throw ModelError(fmt::format("the model mixes dimensions, which no file can hold: {} is flat, {} is solid",
                                     place_of(model, *flat), place_of(model, *solid)));
    }
    throw ModelError(fmt::format("{}: {}", place_of(model, flat ? *flat : *solid), refused));
}

bool convex(const csg::solid::Outline& outline) {
    if (outline.loops.size() != 1) {
        return false;
    }
    const csg::solid::Loop& loop = outline.loops[0];
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (csg::solid::turn(loop[i], loop[(i + 1) % loop.size()], loop[(i + 2) % loop.size()]) < 0) {
            return false;
        }
    }
    return true;
}

}  // namespace

Extent extent_of(const Model& model) {
    const auto [flat, solid] = first_leaves(model);
    return flat && solid ? Extent::Mixed : flat ? Extent::Flat : solid ? Extent::Solid : Extent::None;
}

bool shows_misplaced(const Model& model) {
    const bool flat = csg::is_flat(*model.tree);
    for (std::size_t leaf = 0; leaf < model.scene.leaves.size(); ++leaf) {
        if (model.geometry.leaves[leaf].solid->flat != flat &&
            counts(model.scene.parts[model.scene.leaves[leaf].part])) {
            return true;
        }
    }
    return false;
}

void need_solid(const Model& model) {
    need(model, Extent::Solid, "the model is flat; write .svg, .dxf or .pdf, or make a solid of it (linear_extrude)");
}

void need_flat(const Model& model) {
    need(model, Extent::Flat, "the model is solid; .svg, .dxf and .pdf need a flat one (projection)");
}

Json to_json(const csg::solid::Outline& outline) {
    const csg::Box box = csg::solid::bounds_of(outline.loops);
    const auto array = [](const glm::dvec3& v) { return Json{v.x, v.y}; };
    return {{"dimensions", 2},
            {"convex", convex(outline)},
            {"contours", outline.loops.size()},
            {"area", outline.area()},
            {"bounding_box", {{"min", array(box.lo)}, {"max", array(box.hi)}, {"size", array(box.size())}}}};
}

}  // namespace ui
