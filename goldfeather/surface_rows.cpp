#include "goldfeather/surface_rows.h"

namespace goldfeather {

SurfaceRows surface_rows(const csg::Scene& scene, const csg::solid::Geometry& geometry) {
    SurfaceRows rows;
    if (!geometry.box.empty()) {
        rows.local_centre = geometry.box.centre();
        rows.diagonal = geometry.box.diagonal();
    }
    rows.leaves.reserve(scene.leaves.size());
    for (const csg::LeafInstance& leaf : scene.leaves) {
        rows.leaves.push_back({{leaf.color.r, leaf.color.g, leaf.color.b, leaf.color.a},
                               {leaf.part, static_cast<std::uint32_t>(scene.parts[leaf.part].kind), 0, 0}});
    }
    rows.planes.reserve(geometry.planes.planes().size());
    for (const csg::solid::Plane& p : geometry.planes.planes()) {
        rows.planes.emplace_back(glm::vec3(p.normal),
                                 static_cast<float>(p.offset - glm::dot(p.normal, rows.local_centre)));
    }
    return rows;
}

}  // namespace goldfeather
