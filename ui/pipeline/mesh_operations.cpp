#include "ui/pipeline/mesh_operations.h"

#include <array>
#include <exception>
#include <new>

#include "csg/reference/boolean.h"
#include "csg/reference/hull.h"
#include "csg/reference/nef.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"

namespace ui {

namespace {

using csg::solid::Mesh;
using csg::solid::MeshResult;

csg::reference::Mesh to_reference(const Mesh& mesh) {
    return {mesh.points, mesh.triangles, std::vector<std::uint32_t>(mesh.triangles.size(), 0)};
}

/// A problem instead of an exception.
template <typename Make>
MeshResult answer(const Make& make) {
    try {
        csg::reference::Mesh mesh = make();
        return {{std::move(mesh.points), std::move(mesh.triangles)}, {}};
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return {{}, error.what()};
    }
}

csg::Operation operation_of(csg::solid::BooleanKind kind) {
    switch (kind) {
        case csg::solid::BooleanKind::Difference:
            return csg::Operation::Difference;
        case csg::solid::BooleanKind::Intersection:
            return csg::Operation::Intersection;
        case csg::solid::BooleanKind::Union:
            break;
    }
    return csg::Operation::Union;
}

class Operations : public csg::solid::MeshOperations {
  public:
    MeshResult boolean(csg::solid::BooleanKind kind, std::span<const Mesh> operands) const override {
        return answer([&] {
            csg::TreeBuilder builder;
            std::vector<csg::NodeId> leaves;
            for (const Mesh& mesh : operands) {
                auto polyhedron = std::make_shared<csg::Polyhedron>();
                polyhedron->points = mesh.points;
                for (const glm::uvec3& t : mesh.triangles) {
                    polyhedron->faces.push_back({t.x, t.z, t.y});  // Clockwise, as OpenSCAD's.
                }
                leaves.push_back(builder.leaf(std::shared_ptr<const csg::Polyhedron>(std::move(polyhedron)), {}));
            }
            const csg::Tree tree = builder.finish(builder.combine(operation_of(kind), leaves, {}));
            const csg::Scene scene = csg::make_scene(tree);
            csg::solid::SolidCache solids;
            const csg::solid::Geometry geometry = csg::solid::place(tree, scene, solids);
            return csg::reference::make_mesh(scene, geometry).mesh;
        });
    }

    MeshResult hull(std::span<const glm::dvec3> points) const override {
        return answer([&] { return csg::reference::hull(points); });
    }

    MeshResult minkowski(const Mesh& a, const Mesh& b) const override {
        return answer([&] {
            const std::array operands{to_reference(a), to_reference(b)};
            return csg::reference::minkowski_sum(operands);
        });
    }

    MeshResult roof(const csg::solid::Outline& /*outline*/, const csg::Roof& /*how*/) const override {
        return {{}, "roof() is not supported"};
    }
};

}  // namespace

std::shared_ptr<const csg::solid::MeshOperations> mesh_operations() {
    return std::make_shared<Operations>();
}

}  // namespace ui
