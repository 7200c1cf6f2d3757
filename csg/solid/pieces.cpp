// Pieces as meshes.
#include <fmt/format.h>

#include <algorithm>

#include "csg/solid/extrude.h"
#include "csg/solid/node_geometry.h"

namespace csg::solid {
namespace {

constexpr unsigned kDeepestBox = 500;

void place(Mesh& mesh, const glm::dmat4& matrix) {
    const glm::dmat4 m = matrix[3][3] != 0 ? matrix * (1.0 / matrix[3][3]) : matrix;
    for (glm::dvec3& p : mesh.points) {
        p = glm::dvec3(m * glm::dvec4(p, 1.0));
    }
    if (glm::determinant(glm::dmat3(m)) < 0) {
        for (glm::uvec3& t : mesh.triangles) {
            std::swap(t.y, t.z);
        }
    }
}

Mesh boolean(BooleanKind kind, std::span<const Mesh> operands, const Tools& tools) {
    return ask(need(tools, "a boolean of meshes").boolean(kind, operands, tools.stop));
}

std::shared_ptr<const Solid> compute(const BooleanNode& node, const Tools& tools) {
    if (node.computed) {
        return node.computed;
    }
    check_depth(node);
    std::vector<Mesh> operands;
    for (const auto& pieces : node.operands) {
        operands.push_back(united(meshes_of(pieces, tools), tools));
    }
    node.computed = to_solid(boolean(node.kind, operands, tools), true);
    return node.computed;
}

}  // namespace

const MeshOperations& need(const Tools& tools, std::string_view what) {
    if (tools.operations == nullptr) {
        throw GeometryError(fmt::format("it needs {}, which this build has not", what));
    }
    return *tools.operations;
}

Mesh ask(MeshResult result) {
    if (!result.problem.empty()) {
        throw GeometryError(result.problem);
    }
    return std::move(result.mesh);
}

void check_depth(const BooleanNode& node) {
    if (node.depth > kDeepestBox) {
        throw GeometryError(fmt::format("differences and intersections nest deeper than {}", kDeepestBox));
    }
}

std::shared_ptr<Solid> to_solid(Mesh mesh, bool simple) {
    auto solid = std::make_shared<Solid>();
    solid->points = std::move(mesh.points);
    solid->triangles = std::move(mesh.triangles);
    finish(*solid);
    solid->simple = solid->simple || simple;
    return solid;
}

std::vector<Mesh> meshes_of(std::span<const Piece> pieces, const Tools& tools) {
    std::vector<Mesh> meshes;
    for (const Piece& piece : pieces) {
        const auto solid = piece.solid ? piece.solid : compute(*piece.boolean, tools);
        if (solid->triangles.empty()) {
            continue;
        }
        Mesh& mesh = meshes.emplace_back(Mesh{solid->points, solid->triangles});
        place(mesh, piece.placed);
    }
    return meshes;
}

Box bounds_of(std::span<const Mesh> meshes) {
    Box box;
    for (const Mesh& mesh : meshes) {
        for (const glm::dvec3& p : mesh.points) {
            box = enclose(box, p);
        }
    }
    return box;
}

Mesh united(std::vector<Mesh> meshes, const Tools& tools) {
    if (meshes.empty()) {
        return {};
    }
    if (meshes.size() == 1) {
        return std::move(meshes[0]);
    }
    std::vector<Box> boxes;
    boxes.reserve(meshes.size());
    for (const Mesh& mesh : meshes) {
        boxes.push_back(bounds_of(std::span(&mesh, 1)));
    }
    std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.lo.x < b.lo.x; });
    bool apart = true;
    for (std::size_t i = 0; i < boxes.size() && apart; ++i) {
        for (std::size_t j = i + 1; j < boxes.size() && boxes[j].lo.x <= boxes[i].hi.x && apart; ++j) {
            apart = !overlap(boxes[i], boxes[j]);
        }
    }
    if (!apart) {
        return boolean(BooleanKind::Union, meshes, tools);
    }
    Mesh all;
    for (const Mesh& mesh : meshes) {
        const auto first = static_cast<std::uint32_t>(all.points.size());
        all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
        for (const glm::uvec3& t : mesh.triangles) {
            all.triangles.push_back(t + first);
        }
    }
    return all;
}

}  // namespace csg::solid
