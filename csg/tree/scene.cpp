#include "csg/tree/scene.h"

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "csg/tree/dimension.h"
#include "csg/tree/scene_walk.h"

namespace csg {
namespace {

/// The color of the first operands, where it is but one.
Rgba material_color(const Scene& scene, const Part& part) {
    Rgba color;
    bool first = true;
    std::vector<std::uint32_t> stack{part.root};
    while (!stack.empty()) {
        const Expression& e = scene.expressions[stack.back()];
        stack.pop_back();
        if (e.kind == ExpressionKind::Leaf) {
            const Rgba& own = scene.leaves[e.leaf].color;
            if (!first && own != color) {
                return {};
            }
            color = own;
            first = false;
            continue;
        }
        const auto children = scene.children(e);
        const bool one = e.kind != ExpressionKind::Union && !children.empty();
        stack.insert(stack.end(), children.begin(), one ? children.begin() + 1 : children.end());
    }
    return color;
}

class SceneMaker {
  public:
    SceneMaker(const Tree& tree, Showing showing) : walk_(tree, showing) {}

    Scene make(const PartRule& rule) {
        if (tree().root() == kNoNode) {
            return {};
        }
        if (rule.kind == PartRule::Kind::Model && !walk_.has_translucent()) {
            build({PartKind::Solid, "model", {{tree().root()}}});
        } else {
            for (const PartPlan& plan : split_parts(walk_, rule)) {
                build(plan);
            }
        }
        walk_.set_root_aside();
        while (!walk_.waiting.empty()) {
            const PartPlan plan = std::move(walk_.waiting.front());
            walk_.waiting.pop_front();
            build(plan);
        }
        scene_.occurrences = std::move(walk_.occurrences);
        scene_.occurrences.shrink_to_fit();
        scene_.left_out = std::move(walk_.left_out);
        return std::move(scene_);
    }

  private:
    [[nodiscard]] const Tree& tree() const { return walk_.tree(); }

    void build(const PartPlan& plan) {
        Part part;
        part.kind = plan.kind;
        part.first_expression = static_cast<std::uint32_t>(scene_.expressions.size());
        part.first_leaf = static_cast<LeafId>(scene_.leaves.size());
        std::vector<OpenCut> open{{kNoCut, {}}};
        for (const Piece& piece : plan.pieces) {
            bring_open(open, piece.cut, plan);
            const std::uint32_t expression = build_piece(piece, plan);
            open.back().built.push_back(expression);
        }
        bring_open(open, kNoCut, plan);
        (void)united(open.back().built);
        part.root = static_cast<std::uint32_t>(scene_.expressions.size() - 1);
        part.leaf_count = static_cast<LeafId>(scene_.leaves.size()) - part.first_leaf;
        if (part.leaf_count == 0) {
            // Nothing to draw: take the empty expressions back.
            scene_.expressions.resize(part.first_expression);
            return;
        }
        part.name = unique_name(plan);
        part.color = material_color(scene_, part);
        scene_.parts.push_back(std::move(part));
    }

    /// A cut whose first operand is being put together.
    struct OpenCut {
        CutId cut;
        std::vector<std::uint32_t> built;
    };

    [[nodiscard]] unsigned depth(CutId cut) const { return cut == kNoCut ? 0 : walk_.cuts[cut].depth; }

    /// Ends cuts and begins others until `cut` is the innermost that is open.
    void bring_open(std::vector<OpenCut>& open, CutId cut, const PartPlan& plan) {
        std::vector<CutId> way;
        CutId common = cut;
        while (depth(common) >= open.size() || open[depth(common)].cut != common) {  // open[0] is outside of all.
            way.push_back(common);
            common = walk_.cuts[common].outer;
        }
        while (open.size() > depth(common) + 1) {
            end_cut(open, plan);
        }
        for (auto next = way.rbegin(); next != way.rend(); ++next) {
            open.push_back({*next, {}});
        }
    }

    /// The first operand is done: the others, and all together.
    void end_cut(std::vector<OpenCut>& open, const PartPlan& plan) {
        const OpenCut done = std::move(open.back());
        open.pop_back();
        const CutId id = done.cut;
        std::vector<std::uint32_t> operands{united(done.built)};
        const Frame frame = walk_.cuts[id].frame;
        const auto children = tree().children(frame.node);
        walk_.quiet = walk_.cuts[id].copied;
        for (std::uint32_t c = frame.next_child; c < children.size(); ++c) {
            const Piece operand = walk_.child(frame, children[c], c);
            if (!walk_.set_aside(operand, frame, plan.kind)) {
                operands.push_back(build_piece(operand, plan));
            } else if (is_empty_operand(operand, frame)) {
                operands.push_back(add(ExpressionKind::Union, {}));
            }
        }
        walk_.quiet = false;
        walk_.cuts[id].copied = true;
        open.back().built.push_back(combined(frame, operands));
    }

    [[nodiscard]] std::uint32_t united(const std::vector<std::uint32_t>& built) {
        return built.size() == 1 ? built[0] : add(ExpressionKind::Union, built);
    }

    [[nodiscard]] std::uint32_t combined(const Frame& frame, const std::vector<std::uint32_t>& built) {
        if (built.size() == 1) {
            return built[0];
        }
        const Operation op = tree().node(frame.node).operation;
        const std::uint32_t expression = add(op == Operation::Difference     ? ExpressionKind::Difference
                                             : op == Operation::Intersection ? ExpressionKind::Intersection
                                                                             : ExpressionKind::Union,
                                             built);
        scene_.expressions[expression].occurrence = frame.occurrence;
        return expression;
    }

    [[nodiscard]] std::uint32_t add(ExpressionKind kind, const std::vector<std::uint32_t>& built) {
        Expression e;
        e.kind = kind;
        e.first_child = static_cast<std::uint32_t>(scene_.expression_children.size());
        e.child_count = static_cast<std::uint32_t>(built.size());
        scene_.expression_children.insert(scene_.expression_children.end(), built.begin(), built.end());
        scene_.expressions.push_back(e);
        return static_cast<std::uint32_t>(scene_.expressions.size() - 1);
    }

    /// The expression of a subtree, its leaves among the scene's.
    [[nodiscard]] std::uint32_t build_piece(const Piece& piece, const PartPlan& plan) {
        std::vector<Frame> stack;
        stack.push_back(walk_.enter(piece));
        for (;;) {
            Frame& frame = stack.back();
            const auto children = walk_.is_leaf(frame.node) ? std::span<const NodeId>() : tree().children(frame.node);
            if (frame.next_child < children.size()) {
                const std::uint32_t index = frame.next_child++;
                const Piece child = walk_.child(frame, children[index], index);
                if (!walk_.set_aside(child, frame, plan.kind)) {
                    stack.push_back(walk_.enter(child));
                } else if (is_empty_operand(child, frame)) {
                    frame.built.push_back(add(ExpressionKind::Union, {}));
                }
                continue;
            }
            if (walk_.is_leaf(frame.node) && (plan.kind == PartKind::Solid || plan.kind == PartKind::Translucent)) {
                walk_.set_operands_aside(frame);
            }
            const std::uint32_t expression = leave(frame);
            stack.pop_back();
            if (stack.empty()) {
                return expression;
            }
            stack.back().built.push_back(expression);
        }
    }

    /// Of what is left out: it empties an intersection.
    [[nodiscard]] bool is_empty_operand(const Piece& child, const Frame& parent) const {
        return walk_.is_misplaced(child.node) && tree().node(parent.node).operation == Operation::Intersection;
    }

    [[nodiscard]] std::uint32_t leave(const Frame& frame) {
        if (!walk_.is_leaf(frame.node)) {
            return combined(frame, frame.built);
        }
        Expression e;
        e.kind = ExpressionKind::Leaf;
        e.occurrence = frame.occurrence;
        e.leaf = static_cast<LeafId>(scene_.leaves.size());
        scene_.leaves.push_back({frame.node, frame.occurrence, frame.to_world, frame.color,
                                 tree().node(frame.node).where, static_cast<PartId>(scene_.parts.size())});
        scene_.expressions.push_back(e);
        return static_cast<std::uint32_t>(scene_.expressions.size() - 1);
    }

    [[nodiscard]] std::string unique_name(const PartPlan& plan) {
        std::string base = plan.name;
        if (base.empty() && plan.kind == PartKind::Solid) {
            base = "part " + std::to_string(scene_.parts.size() + 1);
        } else if (base.empty()) {
            base = name(plan.kind);
        }
        for (;;) {
            const std::size_t number = ++numbers_[base];
            std::string name = number == 1 ? base : base + " " + std::to_string(number);
            if (names_.insert(name).second) {
                return name;
            }
        }
    }

    SceneWalk walk_;
    Scene scene_;
    std::unordered_set<std::string> names_;
    std::unordered_map<std::string, std::size_t> numbers_;  ///< How many of a name there are.
};

}  // namespace

const char* name(PartKind kind) {
    static constexpr const char* kNames[]{"solid", "translucent", "background", "highlight"};
    return kNames[static_cast<std::size_t>(kind)];
}

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
                for (const std::uint32_t child : children) {
                    box = enclose(box, boxes[child - part.first_expression]);
                }
                break;
            case ExpressionKind::Intersection:
            case ExpressionKind::Difference: {
                const std::size_t positive =
                    e.kind == ExpressionKind::Difference ? std::min<std::size_t>(1, children.size()) : children.size();
                for (std::size_t c = 0; c < positive; ++c) {
                    const Box& child = boxes[children[c] - part.first_expression];
                    box = c == 0 ? child : intersect(box, child);
                }
                if (box.empty()) {
                    box = {};
                }
                break;
            }
        }
    }
    return boxes;
}

Box bounds(const Scene& scene, const Part& part, std::span<const Box> leaf_boxes) {
    return expression_boxes(scene, part, leaf_boxes).back();
}

Scene make_scene(const Tree& tree, Showing showing, const PartRule& rule) {
    return SceneMaker(tree, showing).make(rule);
}

std::vector<OccurrenceId> path_to(const Scene& scene, OccurrenceId occurrence) {
    std::vector<OccurrenceId> path;
    for (; occurrence != kNoOccurrence; occurrence = scene.occurrences[occurrence].parent) {
        path.push_back(occurrence);
    }
    std::reverse(path.begin(), path.end());
    return path;
}

bool is_flat(const Tree& tree) {
    return tree.root() != kNoNode && dimensions(tree)[tree.root()] == Dimension::Flat;
}

}  // namespace csg
