#include "ui/pipeline/mesh/exact_operations.h"

#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>

#include "csg/reference/hull.h"
#include "csg/reference/mesh_boolean.h"
#include "csg/reference/minkowski.h"
#include "csg/reference/roof.h"
#include "csg/reference/voronoi_roof.h"
#include "ui/pipeline/plain_text.h"

namespace ui {

namespace {

using csg::solid::BooleanKind;
using csg::solid::MeshResult;

csg::reference::Mesh to_reference(const csg::solid::Mesh& mesh) {
    return {mesh.points, mesh.triangles, std::vector<std::uint32_t>(mesh.triangles.size(), 0)};
}

csg::ExpressionKind expression_kind(BooleanKind kind) {
    switch (kind) {
        case BooleanKind::Difference:
            return csg::ExpressionKind::Difference;
        case BooleanKind::Intersection:
            return csg::ExpressionKind::Intersection;
        case BooleanKind::Union:
            break;
    }
    return csg::ExpressionKind::Union;
}

/// What csg/reference throws becomes a problem, but for base::Stopped and out of memory.
template <typename Make>
MeshResult answer(Make&& make) {
    MeshResult result;
    try {
        csg::reference::Mesh mesh = make();
        result.mesh = {std::move(mesh.points), std::move(mesh.triangles)};
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::length_error&) {
        throw;
    } catch (const std::exception& error) {
        result.problem = plain(error.what());
    }
    return result;
}

class ExactOperations final : public csg::solid::MeshOperations {
  public:
    [[nodiscard]] MeshResult boolean(BooleanKind kind, std::span<const csg::solid::Mesh> operands,
                                     const std::stop_token& stop) const override {
        return answer([&] {
            std::vector<csg::reference::Mesh> meshes;
            for (const csg::solid::Mesh& operand : operands) {
                meshes.push_back(to_reference(operand));
            }
            return csg::reference::combine(expression_kind(kind), meshes, stop).mesh;
        });
    }
    [[nodiscard]] MeshResult hull(std::span<const glm::dvec3> points, const std::stop_token& stop) const override {
        return answer([&] { return csg::reference::hull(points, stop); });
    }
    [[nodiscard]] MeshResult minkowski(std::span<const std::vector<csg::solid::Mesh>> operands,
                                       const std::stop_token& stop) const override {
        return answer([&] {
            std::vector<std::vector<csg::reference::Mesh>> unions;
            for (const auto& operand : operands) {
                auto& meshes = unions.emplace_back();
                std::transform(operand.begin(), operand.end(), std::back_inserter(meshes), to_reference);
            }
            return csg::reference::minkowski_sum(unions, stop);
        });
    }
    [[nodiscard]] MeshResult roof(const csg::solid::Outline& outline, const csg::Roof& how,
                                  const std::stop_token& stop) const override {
        return answer([&] {
            return how.method == "straight" ? csg::reference::roof(outline.loops, stop)
                                            : csg::reference::voronoi_roof(outline.loops, how.fineness, stop);
        });
    }
};

}  // namespace

std::shared_ptr<const csg::solid::MeshOperations> exact_operations() {
    return std::make_shared<ExactOperations>();
}

}  // namespace ui
