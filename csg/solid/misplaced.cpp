#include "csg/solid/misplaced.h"

#include <algorithm>

namespace csg::solid {
namespace {

constexpr const char* kMixed = "Mixing 2D and 3D objects is not supported";
constexpr const char* kSolidIgnored = "Ignoring 3D child object for 2D operation";
constexpr const char* kFlatIgnored = "Ignoring 2D child object for 3D operation";

template <typename... Ts>
bool is_one_of(const Tree& tree, NodeId id) {
    return tree.node(id).operation == Operation::Mesh && (std::holds_alternative<Ts>(tree.mesh(id)) || ...);
}

/// It takes whatever its first child is.
bool combines(const Tree& tree, NodeId id) {
    return !is_one_of<LinearExtrude, RotateExtrude, Roof, Offset, Projection>(tree, id);
}

bool is_union(const Tree& tree, NodeId id) {
    const Operation op = tree.node(id).operation;
    return op == Operation::Group || op == Operation::Union || op == Operation::Transform || op == Operation::Color;
}

bool takes_solids(const Tree& tree, NodeId id, Dimension made) {
    return is_one_of<Projection>(tree, id) || (combines(tree, id) && made == Dimension::Solid);
}

}  // namespace

MisplacedOutlines::MisplacedOutlines(const Tree& tree, NodeId parent)
    : combines_(combines(tree, parent)), tells_of_empty_(!is_union(tree, parent) && !is_one_of<Hull>(tree, parent)) {}

std::vector<const char*> MisplacedOutlines::next(bool empty) {
    std::vector<const char*> texts;
    if (combines_ && !empty && !mixing_told_) {
        mixing_told_ = true;
        texts.push_back(kMixed);
    }
    if (!empty || tells_of_empty_) {
        texts.push_back(kFlatIgnored);
    }
    return texts;
}

std::vector<ChildRemark> misplaced_children(const Tree& tree, NodeId id,
                                            std::span<const NodeGeometry* const> children) {
    std::vector<ChildRemark> remarks;
    Dimension made = Dimension::None;
    for (const NodeGeometry* child : children) {
        made = made == Dimension::None ? child->dimension : made;
    }
    const bool solids = takes_solids(tree, id, made);
    const Dimension other = solids ? Dimension::Flat : Dimension::Solid;
    MisplacedOutlines outlines(tree, id);
    bool mixing_told = !combines(tree, id);
    for (std::uint32_t i = 0; i < children.size(); ++i) {
        const NodeGeometry& child = *children[i];
        if (child.dimension != other) {
            continue;
        }
        if (solids) {
            for (const char* text : outlines.next(child.outline->empty())) {
                remarks.push_back({i, text});
            }
            continue;
        }
        if (!mixing_told && !child.pieces.empty()) {
            mixing_told = true;
            remarks.push_back({i, kMixed});
        }
        remarks.push_back({i, kSolidIgnored});
    }
    // Of mixing is told first, wherever the first of them stands that counts for it.
    std::stable_partition(remarks.begin(), remarks.end(), [](const ChildRemark& r) { return r.text == kMixed; });
    return remarks;
}

}  // namespace csg::solid
