// How a tree is walked where it is flattened to a scene. Internal to csg/tree.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "csg/tree/dimension.h"
#include "csg/tree/scene.h"

namespace csg {

/// Differences and intersections between the root and a piece, the innermost: an index into SceneWalk::cuts.
using CutId = std::uint32_t;
inline constexpr CutId kNoCut = ~CutId{0};

/// A subtree with what it inherits from above.
struct Piece {
    NodeId node = kNoNode;
    glm::dmat4 to_world{1.0};
    Rgba color{};
    OccurrenceId parent = kNoOccurrence;
    std::uint32_t child = 0;  ///< Which of the parent's.
    CutId cut = kNoCut;       ///< What it is an operand of, where that is shared with other parts.
};

/// A node on the way down: an occurrence, with what its children inherit.
struct Frame {
    NodeId node;
    glm::dmat4 to_world;
    Rgba color{};
    OccurrenceId occurrence;
    std::uint32_t next_child = 0;
    std::vector<std::uint32_t> built;  ///< Expressions of the children that are done.
};

/// A difference or an intersection whose first operand is divided among parts; each has a copy of the others.
struct Cut {
    Frame frame;  ///< `next_child` is the second operand.
    CutId outer = kNoCut;
    unsigned depth = 1;   ///< With those further out.
    bool copied = false;  ///< A part has its copy.
};

/// Whether `#` holds for all that a node makes.
struct Highlighted {
    bool itself = false;
    bool by_operands = false;  ///< By those of all of its operands; of a difference, by that of the first.
    [[nodiscard]] bool is() const { return itself || by_operands; }
};

/// What is to be one part.
struct PartPlan {
    PartKind kind = PartKind::Solid;
    std::string name;           ///< May be another part's as well; empty: after the kind.
    std::vector<Piece> pieces;  ///< In document order.
};

/// The tree, what is known of its nodes, and what a walk leaves behind.
class SceneWalk {
  public:
    /// `tree` must outlive it.
    SceneWalk(const Tree& tree, Showing showing);

    [[nodiscard]] const Tree& tree() const { return tree_; }
    [[nodiscard]] Dimension dimension(NodeId id) const { return dimensions_[id]; }
    /// Drawn as one: a shape, what makes a mesh of its children, and differences and intersections in the plane where
    /// nothing below has a color or a modifier. A result in the plane is but one leaf.
    [[nodiscard]] bool is_leaf(NodeId id) const;
    [[nodiscard]] bool is_union(NodeId id) const;
    /// Not shown at all, or shown as a part that is not of the solid.
    [[nodiscard]] bool is_left_out(NodeId id) const { return tree_.node(id).modifiers.background || is_misplaced(id); }
    /// An outline where a solid is asked for: an operand all the same, an empty one.
    [[nodiscard]] bool is_misplaced(NodeId id) const {
        return showing_ == Showing::Result && dimensions_[id] == Dimension::Flat &&
               !tree_.node(id).modifiers.background;
    }
    /// Whether some color is seen through.
    [[nodiscard]] bool has_translucent() const { return translucent_; }

    /// Records an occurrence of it.
    [[nodiscard]] Frame enter(const Piece& piece);
    /// A child of the node entered.
    [[nodiscard]] Piece child(const Frame& parent, NodeId id, std::uint32_t index) const {
        return {id, parent.to_world, parent.color, parent.occurrence, index};
    }
    /// A part that waits for the whole tree, where it is highlighted.
    void set_root_aside();
    /// Operands of a hull and its kin that show beside it: those with `%` or `#`.
    void set_operands_aside(const Frame& leaf);
    /// True where `child` is not part of the expression of a part of this kind, but of a part of its own, which waits
    /// then.
    [[nodiscard]] bool set_aside(const Piece& child, const Frame& parent, PartKind kind);

    /// A name for what the subtree makes: of the module that is all of it, or of the color; empty where there is none.
    [[nodiscard]] std::string name_of(const Piece& piece) const;

    std::deque<PartPlan> waiting;
    std::vector<Cut> cuts;
    std::vector<Occurrence> occurrences;
    std::vector<LeftOut> left_out;
    bool quiet = false;  ///< What is walked has been walked before: nothing is to wait again.

  private:
    void wait(PartKind kind, const Piece& piece);
    /// Whether the highlight of a child is its own, not that of all its parent makes.
    [[nodiscard]] bool stands_out(NodeId child, NodeId parent) const;

    const Tree& tree_;
    const Showing showing_;
    const std::vector<Dimension> dimensions_;
    const std::vector<char> marked_;  ///< By node: something below has a color or a modifier of its own to show.
    const std::vector<Highlighted> highlighted_;  ///< By node.
    const bool translucent_;
};

/// The parts of the solid.
[[nodiscard]] std::vector<PartPlan> split_parts(SceneWalk& walk, const PartRule& rule);

}  // namespace csg
