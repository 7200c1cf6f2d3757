// The CSG tree: immutable nodes in an arena, children before parents.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "csg/tree/leaf_shape.h"
#include "csg/tree/mesh_operation.h"
#include "csg/tree/source_location.h"
#include "csg/tree/statement.h"

namespace csg {

using NodeId = std::uint32_t;
inline constexpr NodeId kNoNode = ~NodeId{0};

enum class Operation : std::uint8_t {
    Group,         ///< Union of its children that came from `group`, a module, `for`, `if`, … (OpenSCAD's group()).
    Union,         ///< union()
    Difference,    ///< First child minus all others.
    Intersection,  ///< intersection() and intersection_for()
    Transform,     ///< Union of its children, transformed by a matrix.
    Color,         ///< Union of its children, colored where they have no color from further up.
    Leaf,          ///< A shape; no children.
    Mesh,          ///< Makes one mesh or outline of its children: linear_extrude, hull, offset, …
};

/// OpenSCAD's modifier characters. `*` leaves no node. `!` decides the root before the tree is finished.
struct Modifiers {
    bool background = false;  ///< `%`: drawn for orientation, not part of the solid.
    bool highlight = false;   ///< `#`: part of the solid, and drawn highlighted as well.
    bool root = false;        ///< `!`: kept for the .csg text only.
    bool operator==(const Modifiers&) const = default;
};

/// RGB and opacity, each 0 to 1 (more is drawn as 1). A component below 0 means "not given": the surroundings decide.
struct Rgba {
    float r = -1, g = -1, b = -1, a = 1;
    /// Wholly: no color() further down has a say.
    [[nodiscard]] bool given() const { return r >= 0 && g >= 0 && b >= 0 && a >= 0; }
    [[nodiscard]] bool translucent() const { return a >= 0 && a < 1; }
    bool operator==(const Rgba&) const = default;
};

struct Node {
    Operation operation = Operation::Group;
    Modifiers modifiers;
    SourceLocation where;
    std::uint32_t first_child = 0;  ///< Index into the arena's child list; see Tree::children.
    std::uint32_t child_count = 0;
    std::uint32_t payload = 0;  ///< Index of the matrix, color, shape or mesh operation of this kind of node.
    std::uint64_t hash = 0;     ///< Of the content below, source locations left out.
};

/// An immutable CSG tree (a directed acyclic graph: equal subtrees from the same place are one node). Copying is
/// cheap only by reference: keep it in a shared_ptr<const Tree>. Nothing in it recurses, destruction included.
class Tree {
  public:
    [[nodiscard]] NodeId root() const { return root_; }  ///< kNoNode for an empty model.
    [[nodiscard]] std::size_t size() const { return nodes_.size(); }
    [[nodiscard]] const Node& node(NodeId id) const { return nodes_[id]; }
    [[nodiscard]] std::span<const NodeId> children(NodeId id) const {
        return std::span(child_ids_).subspan(nodes_[id].first_child, nodes_[id].child_count);
    }
    /// For Operation::Transform: child coordinates to parent coordinates, column vectors.
    [[nodiscard]] const glm::dmat4& matrix(NodeId id) const { return matrices_[nodes_[id].payload]; }
    /// For Operation::Color.
    [[nodiscard]] const Rgba& color(NodeId id) const { return colors_[nodes_[id].payload]; }
    /// For Operation::Leaf.
    [[nodiscard]] const LeafShape& shape(NodeId id) const { return shapes_[nodes_[id].payload]; }
    /// For Operation::Mesh.
    [[nodiscard]] const MeshOperation& mesh(NodeId id) const { return meshes_[nodes_[id].payload]; }
    /// Source file names, indexed by SourceLocation::file.
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }
    /// The calls that made the nodes, in the order of SourceLocation; none where no text did.
    [[nodiscard]] std::span<const Statement> statements() const { return statements_; }
    /// The call that made a node; null where none is known, as of the root's group. Takes a binary search.
    [[nodiscard]] const Statement* statement(NodeId id) const;

  private:
    friend class TreeBuilder;
    std::vector<Node> nodes_;
    std::vector<NodeId> child_ids_;
    std::vector<glm::dmat4> matrices_;
    std::vector<Rgba> colors_;
    std::vector<LeafShape> shapes_;
    std::vector<MeshOperation> meshes_;
    std::vector<std::string> files_;
    std::vector<Statement> statements_;
    NodeId root_ = kNoNode;
};

/// Grows a tree from its leaves. A node added twice with the same content, modifiers and place is one node.
class TreeBuilder {
  public:
    /// Index for SourceLocation::file.
    std::uint32_t file(const std::string& name);

    NodeId leaf(LeafShape shape, SourceLocation where, Modifiers modifiers = {});
    /// Group, Union, Difference or Intersection of nodes added before.
    NodeId combine(Operation operation, std::span<const NodeId> children, SourceLocation where,
                   Modifiers modifiers = {});
    NodeId transform(const glm::dmat4& matrix, std::span<const NodeId> children, SourceLocation where,
                     Modifiers modifiers = {});
    NodeId color(const Rgba& color, std::span<const NodeId> children, SourceLocation where, Modifiers modifiers = {});

    NodeId mesh(const MeshOperation& operation, std::span<const NodeId> children, SourceLocation where,
                Modifiers modifiers = {});

    [[nodiscard]] const Node& node(NodeId id) const { return tree_.nodes_[id]; }
    [[nodiscard]] std::span<const NodeId> children(NodeId id) const { return tree_.children(id); }

    /// Hands the tree over; the builder is empty afterwards. `statements`: those of the nodes, in any order, each once.
    [[nodiscard]] Tree finish(NodeId root, std::vector<Statement> statements = {});

  private:
    NodeId add(Node node, std::span<const NodeId> children);
    /// Whether two nodes are equal in all but hash, place and children, which have been compared.
    [[nodiscard]] bool same_content(const Node& a, const Node& b) const;
    /// Adds a node and what it has beside its children; `payloads` are the tree's of its kind.
    template <typename T>
    NodeId keep(Node node, std::span<const NodeId> children, std::vector<T>& payloads, T payload);

    Tree tree_;
    std::vector<NodeId> buckets_;  ///< Open hash table of nodes, for sharing.
    void grow();
};

}  // namespace csg
