// The leaves of a scene in groups that have nothing to do with each other.
#pragma once

#include <deque>
#include <span>
#include <stop_token>
#include <vector>

#include "csg/reference/expression_value.h"
#include "csg/reference/leaf_group.h"

namespace csg::reference {

/// A group with how its leaves are combined and where they come from.
struct CombinedLeaves {
    LeafGroup group;
    GroupExpression expression;
    std::vector<LeafId> sources;  ///< Leaves of the scene.
};

/// What the scene's solid is at a point follows from the leaves whose boxes hold it. So those that can be seen, which
/// are not subtracted from anything, fall into groups whose boxes do not meet (touching boxes do): the solid is that of
/// each group, concatenated. What is subtracted goes to each group that it meets, unless that would be many triangles
/// too often: then those groups are one. A leaf's box is cut down to the boxes of all expressions that it is in, and a
/// leaf of several shells is taken apart first (leaf_pieces.h).
class LeafGroups {
  public:
    /// `leaves` (sorted) take part. Keeps the references. Throws base::Stopped.
    LeafGroups(const Scene& scene, const solid::Geometry& geometry, std::span<const LeafId> leaves,
               const std::stop_token& stop);

    [[nodiscard]] std::size_t size() const { return first_.empty() ? 0 : first_.size() - 1; }
    /// Encloses the solid.
    [[nodiscard]] const Box& extent() const { return extent_; }
    /// Of planes.
    [[nodiscard]] double tolerance() const { return geometry_.planes.tolerance(); }
    [[nodiscard]] std::size_t triangles(std::size_t group) const;
    /// The leaf, where the group's solid is that of one leaf as it is; null where it is not.
    struct Alone {
        const solid::PlacedLeaf* leaf = nullptr;
        LeafId source = 0;
    };
    [[nodiscard]] Alone alone(std::size_t group) const;
    /// May be called by several threads.
    [[nodiscard]] CombinedLeaves combined(std::size_t group) const;

  private:
    /// A leaf, or a piece of one.
    struct Unit {
        LeafId leaf;
        const solid::PlacedLeaf* placed;
        Box box;  ///< Where it matters; with a margin.
    };
    /// What a leaf's expression is to the whole, by index; the scene's union of parts is the last.
    struct Above {
        std::uint32_t parent = GroupExpression::kNone;  ///< Unions in unions are left out.
        bool first = false, complement = false;
        bool carried = true;  ///< Not subtracted from anything.
        bool plain = true;    ///< Where nothing else is, the whole is this.
    };

    void look_above(std::span<const Box> leaf_boxes, std::vector<Box>& boxes);
    void make_units(std::span<const LeafId> leaves, double margin, const std::stop_token& stop);
    void make_groups(const std::stop_token& stop);

    const Scene& scene_;
    const solid::Geometry& geometry_;
    std::deque<std::vector<solid::PlacedLeaf>> pieces_;
    std::vector<Unit> units_;
    std::vector<Above> above_;
    std::vector<std::uint32_t> node_of_;          ///< By leaf of the scene.
    std::vector<std::uint32_t> first_, members_;  ///< Units of group g from first_[g] on, sorted.
    Box extent_;
};

}  // namespace csg::reference
