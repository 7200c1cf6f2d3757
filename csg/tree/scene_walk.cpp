#include "csg/tree/scene_walk.h"

#include <algorithm>
#include <cmath>

namespace csg {
namespace {

bool holds_translucent(const Tree& tree) {
    for (NodeId id = 0; id < tree.size(); ++id) {
        if (tree.node(id).operation == Operation::Color && tree.color(id).translucent()) {
            return true;
        }
    }
    return false;
}

std::vector<char> marked_below(const Tree& tree) {
    std::vector<char> marked(tree.size(), 0);
    for (NodeId id = 0; id < tree.size(); ++id) {
        for (const NodeId child : tree.children(id)) {
            const Modifiers& modifiers = tree.node(child).modifiers;
            if (marked[child] != 0 || modifiers.background || modifiers.highlight ||
                tree.node(child).operation == Operation::Color) {
                marked[id] = 1;
            }
        }
    }
    return marked;
}

/// As OpenSCAD has it. What makes nothing does not count.
std::vector<Highlighted> highlighted(const Tree& tree, const std::vector<Dimension>& dimensions) {
    std::vector<Highlighted> result(tree.size());
    for (NodeId id = 0; id < tree.size(); ++id) {
        const Operation op = tree.node(id).operation;
        bool any = false, all = true;
        const bool is_mesh = op == Operation::Mesh && !std::holds_alternative<Render>(tree.mesh(id));
        for (const NodeId child : is_mesh ? std::span<const NodeId>() : tree.children(id)) {
            if (tree.node(child).modifiers.background || dimensions[child] == Dimension::None) {
                continue;
            }
            any = true;
            all = all && result[child].is();
            if (op == Operation::Difference) {
                break;
            }
        }
        result[id] = {tree.node(id).modifiers.highlight, any && all};
    }
    return result;
}

}  // namespace

SceneWalk::SceneWalk(const Tree& tree, Showing showing)
    : tree_(tree),
      showing_(showing),
      dimensions_(dimensions(tree)),
      marked_(marked_below(tree)),
      highlighted_(highlighted(tree, dimensions_)),
      translucent_(holds_translucent(tree)) {}

bool SceneWalk::is_leaf(NodeId id) const {
    if (showing_ == Showing::Result && id == tree_.root() && dimensions_[id] == Dimension::Flat) {
        return true;
    }
    const Operation op = tree_.node(id).operation;
    if (op == Operation::Mesh) {
        return !std::holds_alternative<Render>(tree_.mesh(id));
    }
    return op == Operation::Leaf || ((op == Operation::Difference || op == Operation::Intersection) &&
                                     dimensions_[id] == Dimension::Flat && marked_[id] == 0);
}

bool SceneWalk::is_union(NodeId id) const {
    const Operation op = tree_.node(id).operation;
    return op == Operation::Group || op == Operation::Union || op == Operation::Transform || op == Operation::Color ||
           (op == Operation::Mesh && !is_leaf(id));
}

Frame SceneWalk::enter(const Piece& piece) {
    const auto occurrence = static_cast<OccurrenceId>(occurrences.size());
    occurrences.push_back({piece.parent, piece.node, piece.child});
    Frame frame{piece.node, piece.to_world, piece.color, occurrence, 0, {}};
    if (is_leaf(piece.node)) {
        return frame;
    }
    const Operation op = tree_.node(piece.node).operation;
    if (op == Operation::Transform) {
        frame.to_world = piece.to_world * tree_.matrix(piece.node);
    } else if (op == Operation::Color && !piece.color.given()) {
        frame.color = tree_.color(piece.node);
    }
    return frame;
}

void SceneWalk::wait(PartKind kind, const Piece& piece) {
    if (quiet) {
        return;
    }
    Piece root = piece;
    root.cut = kNoCut;
    waiting.push_back({kind, name_of(root), {root}});
}

void SceneWalk::set_root_aside() {
    if (showing_ == Showing::Preview && highlighted_[tree_.root()].is()) {
        wait(PartKind::Highlight, {tree_.root()});
    }
}

void SceneWalk::set_operands_aside(const Frame& leaf) {
    if (showing_ != Showing::Preview || tree_.node(leaf.node).operation != Operation::Mesh) {
        return;
    }
    const MeshOperation& mesh = tree_.mesh(leaf.node);
    if (!std::holds_alternative<Hull>(mesh) && !std::holds_alternative<Minkowski>(mesh) &&
        !std::holds_alternative<Resize>(mesh) && !std::holds_alternative<Fill>(mesh)) {
        return;  // OpenSCAD shows none of others.
    }
    const auto children = tree_.children(leaf.node);
    for (std::uint32_t i = 0; i < children.size(); ++i) {
        const NodeId id = children[i];
        const bool background = tree_.node(id).modifiers.background;
        if (background || (highlighted_[id].is() && dimensions_[id] != Dimension::None)) {
            wait(background ? PartKind::Background : PartKind::Highlight,
                 {id, leaf.to_world, leaf.color, leaf.occurrence, i});
        }
    }
}

bool SceneWalk::stands_out(NodeId child, NodeId parent) const {
    return highlighted_[child].is() && !highlighted_[parent].by_operands && dimensions_[child] != Dimension::None;
}

bool SceneWalk::set_aside(const Piece& child, const Frame& parent, PartKind kind) {
    if (is_left_out(child.node)) {
        if (is_misplaced(child.node) && !quiet) {
            left_out.push_back({parent.occurrence, child.node});
        } else if (showing_ != Showing::Result && kind != PartKind::Highlight) {  // There it was found with the solid.
            wait(PartKind::Background, child);
        }
        return true;
    }
    if (showing_ == Showing::Preview && kind != PartKind::Highlight && kind != PartKind::Background &&
        stands_out(child.node, parent.node)) {
        wait(PartKind::Highlight, child);
        if (is_union(parent.node)) {
            return true;
        }
    }
    return false;
}

std::string SceneWalk::name_of(const Piece& piece) const {
    Rgba color = piece.color;
    for (NodeId id = piece.node;;) {
        if (const Statement* statement = tree_.statement(id);
            statement != nullptr && statement->user_module && tree_.node(id).operation == Operation::Group) {
            return statement->name;
        }
        if (tree_.node(id).operation == Operation::Color && !color.given()) {
            color = tree_.color(id);
        }
        // On to the one child that counts; a difference is what it is made of.
        NodeId next = kNoNode;
        bool several = false;
        if (!is_leaf(id)) {
            for (const NodeId child : tree_.children(id)) {
                if (is_left_out(child) || dimensions_[child] == Dimension::None) {
                    continue;
                }
                several = next != kNoNode && is_union(id);
                if (next == kNoNode) {
                    next = child;
                } else {
                    break;
                }
            }
        }
        if (next == kNoNode || several) {
            return color.given() ? color_name(color) : "";
        }
        id = next;
    }
}

std::string color_name(const Rgba& color) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string name = "#";
    for (const float component : {color.r, color.g, color.b, color.a}) {
        const auto byte = static_cast<unsigned>(std::lround(255 * std::clamp(component, 0.0F, 1.0F)));
        name += kDigits[byte / 16];
        name += kDigits[byte % 16];
    }
    return color.a < 1 ? name : name.substr(0, 7);
}

}  // namespace csg
