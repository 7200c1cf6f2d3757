// What a node of the tree is: outlines, or a union of solids that may still have to be computed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "csg/solid/mesh_operations.h"
#include "csg/solid/solid.h"
#include "csg/tree/dimension.h"

namespace csg::solid {

struct BooleanNode;

/// A solid somewhere; either a mesh or a difference or intersection that nobody has needed as a mesh yet.
struct Piece {
    std::shared_ptr<const Solid> solid;
    std::shared_ptr<const BooleanNode> boolean;  ///< Where there is no `solid`.
    glm::dmat4 placed{1.0};
};

/// Operands are unions of pieces.
struct BooleanNode {
    BooleanKind kind = BooleanKind::Difference;
    std::vector<std::vector<Piece>> operands;
    unsigned depth = 0;                             ///< Of such nodes below each other.
    mutable std::shared_ptr<const Solid> computed;  ///< Filled when it was asked for; not for several threads.
};

/// What there is to say of a child of a node (`%` children left out), by its number.
struct ChildRemark {
    std::uint32_t child;
    const char* text;
};

struct NodeGeometry {
    Dimension dimension = Dimension::None;
    std::shared_ptr<const Outline> outline;  ///< In the plane; null where it is solid.
    std::vector<Piece> pieces;               ///< Their union.
    std::vector<std::string> warnings;       ///< Of this node alone.
    std::vector<ChildRemark> misplaced;      ///< Warnings of children that are not of the dimension asked for.
    std::vector<std::string> failures;       ///< Why this node is not, or not all, of what was asked for.
};

class FontLibrary;

/// What making geometry needs besides the tree.
struct Tools {
    const MeshOperations* operations = nullptr;  ///< May be missing: what needs it then fails.
    FontLibrary& fonts;
    std::function<std::shared_ptr<const Solid>(const LeafShape&)> solid_of;
    std::stop_token stop{};  ///< Where it is asked for, base::Stopped is thrown.
};

/// Of one node from its children (in the order of the tree, `%` children left out). Never throws for what the user
/// wrote: whatever cannot be made is empty, and among the failures. Throws OutOfMemory.
[[nodiscard]] NodeGeometry make_geometry(const Tree& tree, NodeId id, Dimension dimension,
                                         std::span<const NodeGeometry* const> children, const Tools& tools);

/// One mesh: outlines as slabs, several pieces as their union; where that cannot be made, nothing and a failure.
[[nodiscard]] std::shared_ptr<const Solid> as_solid(const NodeGeometry& geometry, const Tools& tools);

// pieces.cpp

/// The operations on meshes. Throws GeometryError where there are none, with `what` as what is missed.
[[nodiscard]] const MeshOperations& need(const Tools& tools, std::string_view what);
/// The mesh of an answer. Throws GeometryError where it is a problem.
[[nodiscard]] Mesh ask(MeshResult result);
/// Throws GeometryError where differences and intersections nest deeper than can be computed.
void check_depth(const BooleanNode& node);

/// Each piece as a mesh in the coordinates of the node. Throws GeometryError.
[[nodiscard]] std::vector<Mesh> meshes_of(std::span<const Piece> pieces, const Tools& tools);
/// All as one closed mesh; meshes whose boxes are apart are only put together.
[[nodiscard]] Mesh united(std::vector<Mesh> meshes, const Tools& tools);
/// `simple`: as in Solid.
[[nodiscard]] std::shared_ptr<Solid> to_solid(Mesh mesh, bool simple);
[[nodiscard]] Box bounds_of(std::span<const Mesh> meshes);

/// The cut of the pieces by z = 0, needing no boolean of meshes: what is inside just above the plane.
[[nodiscard]] Outline cut(std::span<const Piece> pieces);
/// The shadow on z = 0 of meshes: of what is inside of them, by winding number. shadow.cpp.
[[nodiscard]] Outline shadow(std::span<const Mesh> meshes);

}  // namespace csg::solid
