#include "goldfeather/surface_table.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/part_order.h"
#include "goldfeather/local_frame.h"
#include "goldfeather/part_extents.h"
#include "goldfeather/smooth_groups.h"

namespace goldfeather {

namespace {

layers::PartKind kind_of(const csg::Part& part) {
    switch (part.kind) {
        case csg::PartKind::Solid:
            return layers::PartKind::Solid;
        case csg::PartKind::Translucent:
            return layers::PartKind::Translucent;
        case csg::PartKind::Background:
            return layers::PartKind::Background;
        case csg::PartKind::Highlight:
            return layers::PartKind::Highlight;
    }
    return layers::PartKind::Solid;
}

glm::vec4 row_of(const csg::solid::Plane& plane, const glm::dvec3& local_center) {
    return {glm::vec3(plane.normal), static_cast<float>(plane.offset - glm::dot(plane.normal, local_center))};
}

/// Without an opacity of its own it is opaque, and what is in the background has that of the background; what is of the
/// solid has that of its part. Components above 1 are lit as they are, as in OpenSCAD.
glm::vec4 color_of(const csg::Rgba& c, csg::PartKind kind) {
    const bool none = c.r < 0 && c.g < 0 && c.b < 0;
    const float a = kind == csg::PartKind::Solid                                    ? 1
                    : kind == csg::PartKind::Background && none && !c.translucent() ? -1
                    : c.a < 0                                                       ? 1
                                                                                    : c.a;
    return {c.r, c.g, c.b, std::min(a, 1.0F)};
}

/// Of a leaf's z axis in the world: the octahedron's coordinates in 15 bits each, above the lowest two bits.
std::uint32_t packed_axis(const glm::dmat4& to_world) {
    const glm::dvec3 axis(to_world[2]);
    const double sum = std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z);
    if (!(sum > 0) || !std::isfinite(sum)) {
        return packed_axis(glm::dmat4(1));
    }
    glm::dvec2 at = glm::dvec2(axis) / sum;
    if (axis.z < 0) {
        at = (1.0 - glm::abs(glm::dvec2(at.y, at.x))) * glm::dvec2(at.x < 0 ? -1 : 1, at.y < 0 ? -1 : 1);
    }
    const glm::uvec2 bits(glm::round(at * 16383.0) + 16384.0);
    return bits.x << 2U | bits.y << 17U;
}

void rank_parts(layers::SurfaceTable& table, const csg::Scene& scene, const csg::solid::Geometry& geometry) {
    const std::vector<csg::PartId> order = csg::solid::part_order(scene, &geometry);
    for (std::uint32_t rank = 0; rank < order.size(); ++rank) {
        table.parts[order[rank]].rank = rank;
    }
}

void fill(layers::SurfaceTable& table, const csg::Scene& scene, const csg::solid::Geometry& geometry) {
    const LocalFrame frame = local_frame(geometry);
    table.local_center = frame.center;
    table.diagonal = frame.diagonal;
    table.parts.clear();
    for (const csg::Part& part : scene.parts) {
        table.parts.push_back({part.name, kind_of(part), color_of(part.color, part.kind)});
        const PartExtent extent = extent_of(part, scene, geometry);
        table.parts.back().center = extent.radius > 0 ? extent.center - frame.center : glm::dvec3(0);
        table.parts.back().radius = static_cast<float>(extent.radius);
    }
    rank_parts(table, scene, geometry);
    table.leaves.clear();
    table.leaves.reserve(scene.leaves.size());
    for (std::size_t i = 0; i < scene.leaves.size(); ++i) {
        const csg::LeafInstance& leaf = scene.leaves[i];
        const csg::Part& part = scene.parts[leaf.part];
        // A part that is seen through has its own color on cuts as well.
        const csg::Rgba& color = part.kind == csg::PartKind::Translucent ? part.color : leaf.color;
        const auto& solid = geometry.leaves[i].solid;
        table.leaves.push_back({color_of(color, part.kind),
                                {leaf.part, static_cast<std::uint32_t>(kind_of(part)), leaf.hatching,
                                 (solid && solid->groups_estimated ? 1U : 0U) | packed_axis(leaf.to_world)}});
    }
    table.planes.clear();
    table.planes.reserve(geometry.planes.planes().size());
    for (const csg::solid::Plane& plane : geometry.planes.planes()) {
        table.planes.push_back(row_of(plane, frame.center));
    }
    table.groups = smooth_groups(geometry);
    table.smooth = {};
}

}  // namespace

std::shared_ptr<layers::SurfaceTable> surface_table(const csg::Scene& scene, const csg::solid::Geometry& geometry) {
    auto table = std::make_shared<layers::SurfaceTable>();
    fill(*table, scene, geometry);
    return table;
}

void update(layers::SurfaceTable& table, const csg::Scene& scene, const csg::solid::Geometry& geometry,
            const csg::solid::SceneChange& change) {
    if (change.structure || change.center || change.all_planes) {
        fill(table, scene, geometry);
        return;
    }
    table.diagonal = local_frame(geometry).diagonal;
    for (const std::uint32_t plane : change.planes) {
        table.planes[plane] = row_of(geometry.planes.planes()[plane], table.local_center);
    }
    for (const csg::LeafId leaf : change.leaves) {
        std::uint32_t& word = table.leaves[leaf].part.w;
        word = (word & 3U) | packed_axis(scene.leaves[leaf].to_world);
    }
    if (!change.leaves.empty()) {
        table.groups = smooth_groups(geometry);
        rank_parts(table, scene, geometry);
        table.smooth = {};
    }
}

}  // namespace goldfeather
