#include "goldfeather/surface_table.h"

#include "goldfeather/local_frame.h"

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

}  // namespace

std::shared_ptr<const layers::SurfaceTable> surface_table(const csg::Scene& scene,
                                                          const csg::solid::Geometry& geometry) {
    auto table = std::make_shared<layers::SurfaceTable>();
    const LocalFrame frame = local_frame(geometry);
    table->local_centre = frame.centre;
    table->diagonal = frame.diagonal;
    table->leaves.reserve(scene.leaves.size());
    for (const csg::LeafInstance& leaf : scene.leaves) {
        table->leaves.push_back({{leaf.color.r, leaf.color.g, leaf.color.b, leaf.color.a},
                                 {leaf.part, static_cast<std::uint32_t>(kind_of(scene.parts[leaf.part])), 0, 0}});
    }
    table->planes.reserve(geometry.planes.planes().size());
    for (const csg::solid::Plane& p : geometry.planes.planes()) {
        table->planes.emplace_back(glm::vec3(p.normal),
                                   static_cast<float>(p.offset - glm::dot(p.normal, table->local_centre)));
    }
    return table;
}

}  // namespace goldfeather
