// A tree made ready for drawing: leaves placed in the world, and one boolean expression per part.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "csg/tree/box.h"
#include "csg/tree/part_rule.h"
#include "csg/tree/tree.h"

namespace csg {

using LeafId = std::uint32_t;  ///< Index of a leaf occurrence: part by part, in document order.
using PartId = std::uint32_t;
using OccurrenceId = std::uint32_t;
inline constexpr OccurrenceId kNoOccurrence = ~OccurrenceId{0};

/// One place of a node in the model. Nodes of the tree are shared; this is one of the ways down to one of them.
struct Occurrence {
    OccurrenceId parent = kNoOccurrence;  ///< The node above; it stands before this one. None: this is the root.
    NodeId node = kNoNode;
    std::uint32_t child = 0;  ///< Which of the parent's children it is.
};

/// One occurrence of a leaf of the tree: of a shape, of an operation that makes a mesh (render() makes none), or of a
/// difference or an intersection in the plane, which is drawn as one flat leaf (of a whole tree in the plane where the
/// result is shown).
struct LeafInstance {
    NodeId node = kNoNode;                    ///< The leaf in the tree: a shape, or a node that is one mesh.
    OccurrenceId occurrence = kNoOccurrence;  ///< Of that node; none in scenes that no tree made.
    glm::dmat4 to_world{1.0};                 ///< Leaf coordinates to world coordinates.
    Rgba color;  ///< That of the outermost color() that gives all of it, else of the innermost; maybe in part only.
    SourceLocation where;
    PartId part = 0;
    /// What faces of it are: 0 surfaces like all others; else faces that a section has cut, with a hatching that tells
    /// their part from its neighbors.
    std::uint8_t hatching = 0;
};

enum class ExpressionKind : std::uint8_t { Leaf, Union, Intersection, Difference };

/// A node of a part's expression. Children stand before their parents in Scene::expressions.
struct Expression {
    ExpressionKind kind = ExpressionKind::Leaf;
    LeafId leaf = 0;                ///< For Leaf.
    std::uint32_t first_child = 0;  ///< Into Scene::expression_children; a Difference is first minus the others.
    std::uint32_t child_count = 0;  ///< A Union of none is empty.
    /// Of the node that it is the expression of; where that is the only child of others, it is theirs as well. None
    /// where a rule has put pieces together. Of what is added later: see scene_edit.h.
    OccurrenceId occurrence = kNoOccurrence;
};

enum class PartKind : std::uint8_t {
    Solid,        ///< What the model is.
    Translucent,  ///< What a color() with an opacity below 1 is of, where it is added to the solid.
    Background,   ///< `%`
    Highlight,    ///< `#`, drawn over what it belongs to; in a union, instead of it.
};

/// "solid", "translucent", "background", "highlight".
[[nodiscard]] const char* name(PartKind kind);

/// What is drawn as one object: a subtree, or the pieces that a rule puts together.
struct Part {
    PartKind kind = PartKind::Solid;
    std::uint32_t first_expression = 0;  ///< The part's expressions are a range of Scene::expressions, …
    std::uint32_t root = 0;              ///< … and this, its last, is the root.
    LeafId first_leaf = 0;               ///< The part's leaves are a range of Scene::leaves.
    LeafId leaf_count = 0;
    /// No two parts have the same: "model" where it is all of the solid, else after a module, a color or the order:
    /// "cover", "cover 2", "#ff8000", "part 3".
    std::string name;
    /// That of its material, which is that of the first operands, with its opacity; `given()` is false where there is
    /// none, or more than one.
    Rgba color;
    /// Drawn as if its leaves had no surfaces. It counts for bounds and planes, so that other parts look as before.
    bool hidden = false;
};

/// An outline among solids: an operand that counts as empty where the result is asked for.
struct LeftOut {
    OccurrenceId parent = kNoOccurrence;
    NodeId node = kNoNode;
};

struct Scene {
    std::vector<LeafInstance> leaves;
    std::vector<Expression> expressions;
    std::vector<std::uint32_t> expression_children;
    std::vector<Part> parts;
    std::vector<Occurrence> occurrences;  ///< Of the leaves and of all above them, parents first.
    std::vector<LeftOut> left_out;        ///< In results only; in document order.

    [[nodiscard]] std::span<const std::uint32_t> children(const Expression& e) const {
        return std::span(expression_children).subspan(e.first_child, e.child_count);
    }
};

/// Is the leaf's part hidden?
[[nodiscard]] inline bool is_hidden(const Scene& scene, LeafId leaf) {
    return scene.parts[scene.leaves[leaf].part].hidden;
}

/// What a scene is to show.
enum class Showing : std::uint8_t {
    Preview,  ///< All that is written: `%` and `#` as parts, every outline as a leaf of its own.
    /// What an export would hold: neither `%` nor `#` parts; in the plane one leaf, in space no outlines (each node is
    /// what its first child is: csg/tree/dimension.h).
    Result,
};

/// Flattens `tree`: transforms are multiplied through, colors inherited (the outermost wins, as in OpenSCAD), shared
/// subtrees become occurrences, `%` subtrees parts of their own, `#` subtrees highlight parts (beside what they make
/// where they are operands of a difference or intersection, or all there is; a difference is highlighted as its first
/// operand is), translucent subtrees parts of their own (PartRule). Groups that hold one child are that child. The
/// first part is the Solid one, where there is one; of several where `rule` says so. A tree without geometry gives no
/// parts.
[[nodiscard]] Scene make_scene(const Tree& tree, Showing showing = Showing::Preview, const PartRule& rule = {});

/// The way from the root down to an occurrence, which comes last.
[[nodiscard]] std::vector<OccurrenceId> path_to(const Scene& scene, OccurrenceId occurrence);

/// "#ff8000"; with the opacity behind it where that is below 1.
[[nodiscard]] std::string color_name(const Rgba& color);

/// Whether what the tree makes is an outline in the plane.
[[nodiscard]] bool is_flat(const Tree& tree);

/// Boxes that enclose the part's expressions, by index from its first: boxes of leaves (by LeafId) united and
/// intersected, a difference's that of its first operand.
[[nodiscard]] std::vector<Box> expression_boxes(const Scene& scene, const Part& part, std::span<const Box> leaf_boxes);

/// That of the whole part.
[[nodiscard]] Box bounds(const Scene& scene, const Part& part, std::span<const Box> leaf_boxes);

/// The value of a part's expression where `inside(leaf)` tells whether the point is in a leaf. Each leaf of the part
/// is asked once. `values` is scratch, kept by the caller to spare allocations; afterwards `values[i]` holds the value
/// of expression `part.first_expression + i`.
template <typename Inside>
[[nodiscard]] bool evaluate(const Scene& scene, const Part& part, Inside&& inside, std::vector<char>& values) {
    values.resize(part.root - part.first_expression + 1);
    for (std::uint32_t i = part.first_expression; i <= part.root; ++i) {
        const Expression& e = scene.expressions[i];
        const auto children = scene.children(e);
        const auto value = [&](std::uint32_t child) { return values[child - part.first_expression] != 0; };
        bool result = false;
        switch (e.kind) {
            case ExpressionKind::Leaf:
                result = inside(e.leaf);
                break;
            case ExpressionKind::Union:
                result = std::any_of(children.begin(), children.end(), value);
                break;
            case ExpressionKind::Intersection:
                result = !children.empty() && std::all_of(children.begin(), children.end(), value);
                break;
            case ExpressionKind::Difference:
                result = !children.empty() && value(children[0]) &&
                         std::none_of(children.begin() + 1, children.end(), value);
                break;
        }
        values[i - part.first_expression] = result;
    }
    return values.back() != 0;
}

}  // namespace csg
