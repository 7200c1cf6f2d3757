#include "csg/tree/scene.h"

#include <deque>
#include <utility>

#include "csg/tree/dimension.h"

namespace csg {
namespace {

/// A subtree to be drawn as one part, with what it inherits from above.
struct PartRoot {
    PartKind kind;
    NodeId node;
    glm::dmat4 to_world;
    Rgba color;
};

/// A node on the way down; `built` collects the expressions of the children that are done.
struct Frame {
    NodeId node;
    glm::dmat4 to_world;
    Rgba color;
    bool top_level;  ///< Only unions between here and the part's root.
    std::uint32_t next_child = 0;
    std::vector<std::uint32_t> built;
};

class SceneMaker {
  public:
    SceneMaker(const Tree& tree, Showing showing)
        : tree_(tree), showing_(showing), dimensions_(dimensions(tree)), marked_(marked_below(tree)) {}

    Scene make() {
        if (tree_.root() == kNoNode)
            return {};
        waiting_.push_back({PartKind::Solid, tree_.root(), glm::dmat4(1.0), Rgba{}});
        while (!waiting_.empty()) {
            const PartRoot root = waiting_.front();
            waiting_.pop_front();
            build(root);
        }
        return std::move(scene_);
    }

  private:
    void build(const PartRoot& from) {
        Part part;
        part.kind = from.kind;
        part.first_expression = static_cast<std::uint32_t>(scene_.expressions.size());
        part.first_leaf = static_cast<LeafId>(scene_.leaves.size());
        std::vector<Frame> stack;
        stack.push_back(enter(from.node, from.to_world, from.color, true));
        for (;;) {
            Frame& frame = stack.back();
            const auto children = is_leaf(frame.node) ? std::span<const NodeId>() : tree_.children(frame.node);
            if (frame.next_child < children.size()) {
                const NodeId child = children[frame.next_child++];
                if (set_aside(child, frame, from.kind))
                    continue;
                const bool top = frame.top_level && is_union(frame.node);
                stack.push_back(enter(child, frame.to_world, frame.color, top));
                continue;
            }
            const std::uint32_t expression = leave(frame);
            stack.pop_back();
            if (stack.empty())
                break;
            stack.back().built.push_back(expression);
        }
        part.root = static_cast<std::uint32_t>(scene_.expressions.size() - 1);
        part.leaf_count = static_cast<LeafId>(scene_.leaves.size()) - part.first_leaf;
        if (part.leaf_count == 0) {
            // Nothing to draw: take the empty expressions back.
            scene_.expressions.resize(part.first_expression);
            return;
        }
        scene_.parts.push_back(part);
    }

    /// By node: something below it has a colour or a modifier of its own to show.
    static std::vector<char> marked_below(const Tree& tree) {
        std::vector<char> marked(tree.size(), 0);
        for (NodeId id = 0; id < tree.size(); ++id) {
            for (const NodeId child : tree.children(id)) {
                const Modifiers& modifiers = tree.node(child).modifiers;
                if (marked[child] != 0 || modifiers.background || modifiers.highlight ||
                    tree.node(child).operation == Operation::Color)
                    marked[id] = 1;
            }
        }
        return marked;
    }

    /// Drawn as one: a shape, what makes a mesh of its children, and differences and intersections in the plane where
    /// nothing below has a colour or a modifier. A result in the plane is but one leaf.
    [[nodiscard]] bool is_leaf(NodeId id) const {
        if (showing_ == Showing::Result && id == tree_.root() && dimensions_[id] == Dimension::Flat)
            return true;
        const Operation op = tree_.node(id).operation;
        if (op == Operation::Mesh)
            return !std::holds_alternative<Render>(tree_.mesh(id));
        return op == Operation::Leaf || ((op == Operation::Difference || op == Operation::Intersection) &&
                                         dimensions_[id] == Dimension::Flat && marked_[id] == 0);
    }

    [[nodiscard]] bool is_union(NodeId id) const {
        const Operation op = tree_.node(id).operation;
        return op == Operation::Group || op == Operation::Union || op == Operation::Transform ||
               op == Operation::Color || (op == Operation::Mesh && !is_leaf(id));
    }

    Frame enter(NodeId id, const glm::dmat4& to_world, const Rgba& color, bool top_level) const {
        Frame frame{id, to_world, color, top_level, 0, {}};
        if (is_leaf(id))
            return frame;
        const Operation op = tree_.node(id).operation;
        if (op == Operation::Transform)
            frame.to_world = to_world * tree_.matrix(id);
        else if (op == Operation::Color && !color.given())
            frame.color = tree_.color(id);
        return frame;
    }

    /// True where `child` is not part of the expression being built, but of a part of its own.
    bool set_aside(NodeId child, const Frame& parent, PartKind kind) {
        const Node& node = tree_.node(child);
        if (showing_ == Showing::Result && (node.modifiers.background || dimensions_[child] == Dimension::Flat))
            return true;
        if (node.modifiers.background) {
            if (kind != PartKind::Highlight)  // there it was queued when the solid was built
                waiting_.push_back({PartKind::Background, child, parent.to_world, parent.color});
            return true;
        }
        if (node.modifiers.highlight && showing_ == Showing::Preview && kind != PartKind::Highlight &&
            kind != PartKind::Background)
            waiting_.push_back({PartKind::Highlight, child, parent.to_world, parent.color});
        if (kind == PartKind::Solid && node.operation == Operation::Color && !parent.color.given() &&
            tree_.color(child).a < 1 && parent.top_level && is_union(parent.node)) {
            waiting_.push_back({PartKind::Translucent, child, parent.to_world, parent.color});
            return true;
        }
        return false;
    }

    std::uint32_t leave(const Frame& frame) {
        const Operation op = tree_.node(frame.node).operation;
        Expression e;
        if (is_leaf(frame.node)) {
            e.kind = ExpressionKind::Leaf;
            e.leaf = static_cast<LeafId>(scene_.leaves.size());
            scene_.leaves.push_back({frame.node, frame.to_world, frame.color, tree_.node(frame.node).where,
                                     static_cast<PartId>(scene_.parts.size())});
        } else {
            if (frame.built.size() == 1)
                return frame.built[0];
            e.kind = op == Operation::Difference     ? ExpressionKind::Difference
                     : op == Operation::Intersection ? ExpressionKind::Intersection
                                                     : ExpressionKind::Union;
            e.first_child = static_cast<std::uint32_t>(scene_.expression_children.size());
            e.child_count = static_cast<std::uint32_t>(frame.built.size());
            scene_.expression_children.insert(scene_.expression_children.end(), frame.built.begin(), frame.built.end());
        }
        scene_.expressions.push_back(e);
        return static_cast<std::uint32_t>(scene_.expressions.size() - 1);
    }

    const Tree& tree_;
    const Showing showing_;
    const std::vector<Dimension> dimensions_;
    const std::vector<char> marked_;
    Scene scene_;
    std::deque<PartRoot> waiting_;
};

}  // namespace

std::vector<Box> expression_boxes(const Scene& scene, const Part& part, std::span<const Box> leaf_boxes) {
    std::vector<Box> boxes(part.root - part.first_expression + 1);
    for (std::uint32_t i = part.first_expression; i <= part.root; ++i) {
        const Expression& e = scene.expressions[i];
        Box& box = boxes[i - part.first_expression];
        const auto children = scene.children(e);
        switch (e.kind) {
            case ExpressionKind::Leaf:
                box = leaf_boxes[e.leaf];
                break;
            case ExpressionKind::Union:
                for (const std::uint32_t child : children)
                    box = enclose(box, boxes[child - part.first_expression]);
                break;
            case ExpressionKind::Intersection:
            case ExpressionKind::Difference: {
                const std::size_t positive =
                    e.kind == ExpressionKind::Difference ? std::min<std::size_t>(1, children.size()) : children.size();
                for (std::size_t c = 0; c < positive; ++c) {
                    const Box& child = boxes[children[c] - part.first_expression];
                    box = c == 0 ? child : intersect(box, child);
                }
                if (box.empty())
                    box = {};
                break;
            }
        }
    }
    return boxes;
}

Box bounds(const Scene& scene, const Part& part, std::span<const Box> leaf_boxes) {
    return expression_boxes(scene, part, leaf_boxes).back();
}

Scene make_scene(const Tree& tree, Showing showing) {
    return SceneMaker(tree, showing).make();
}

bool is_flat(const Tree& tree) {
    return tree.root() != kNoNode && dimensions(tree)[tree.root()] == Dimension::Flat;
}

}  // namespace csg
