#include <algorithm>
#include <map>
#include <tuple>

#include "csg/tree/scene_walk.h"

namespace csg {
namespace {

/// The colors of what a subtree makes, as far as nothing above gives one.
struct Tint {
    enum class Kind : std::uint8_t { Nothing, One, Several } kind = Kind::Nothing;
    Rgba color;  ///< For One; not given where it has none.
};

/// Divides the solid; the pieces are found in document order.
class Splitter {
  public:
    Splitter(SceneWalk& walk, const PartRule& rule) : walk_(walk), tree_(walk.tree()), rule_(rule) {
        find_translucent();
        if (rule.kind == PartRule::Kind::Color) {
            find_tints();
        } else if (rule.kind == PartRule::Kind::Module) {
            find_modules();
        }
    }

    std::vector<PartPlan> split() {
        std::vector<Level> stack;
        visit({tree_.root()}, {PartKind::Solid, rule_.depth, kNoPlan}, stack);
        while (!stack.empty()) {
            Level& level = stack.back();
            const auto children = tree_.children(level.frame.node);
            if (level.frame.next_child >= level.end) {
                stack.pop_back();
                continue;
            }
            const std::uint32_t index = level.frame.next_child++;
            Piece child = walk_.child(level.frame, children[index], index);
            child.cut = level.cut;
            if (!walk_.set_aside(child, level.frame, level.place.kind)) {
                visit(child, Place(level.place), stack);
            }
        }
        std::erase_if(plans_, [](const PartPlan& plan) { return plan.pieces.empty(); });
        return std::move(plans_);
    }

  private:
    static constexpr std::size_t kNoPlan = ~std::size_t{0};

    /// What is known of a piece from above.
    struct Place {
        PartKind kind;
        unsigned divisions;  ///< That it may go through.
        std::size_t plan;    ///< The part that all of it belongs to, but for what is translucent; kNoPlan: several.
    };
    /// A node that is divided.
    struct Level {
        Frame frame;
        std::uint32_t end;  ///< Behind the last child that is divided.
        CutId cut;
        Place place;  ///< Of its children.
    };

    /// Takes the piece as a whole, or begins to divide it.
    void visit(const Piece& piece, Place place, std::vector<Level>& stack) {
        const NodeId id = piece.node;
        if (place.kind == PartKind::Solid && begins_translucent(piece)) {
            place = {PartKind::Translucent, place.divisions, kNoPlan};
        }
        const bool is_union = walk_.is_union(id);
        const std::uint32_t first = first_operand(id);
        const auto count = static_cast<std::uint32_t>(tree_.children(id).size());
        const unsigned shared = piece.cut == kNoCut ? 0 : walk_.cuts[piece.cut].depth;
        const bool whole = place.plan != kNoPlan || is_whole(piece, place.divisions);
        const bool mixed = place.kind == PartKind::Solid && holds_translucent(piece);
        if (walk_.is_leaf(id) || first == count || (!is_union && shared >= PartRule::kMostShared) ||
            (whole && !mixed)) {
            plans_[place.plan != kNoPlan ? place.plan : plan_for(piece, place.kind)].pieces.push_back(piece);
            return;
        }
        if (whole && place.plan == kNoPlan) {
            place.plan = plan_for(piece, place.kind);
        }
        Frame frame = walk_.enter(piece);
        if (!is_union || has_several(id)) {
            place.divisions -= std::min(place.divisions, 1U);
        }
        if (is_union) {
            stack.push_back({std::move(frame), count, piece.cut, place});
            return;
        }
        Cut cut{frame, piece.cut, shared + 1};
        cut.frame.next_child = first + 1;
        walk_.cuts.push_back(std::move(cut));
        const auto id_of_cut = static_cast<CutId>(walk_.cuts.size() - 1);
        stack.push_back({std::move(frame), first + 1, id_of_cut, place});
    }

    /// The color that what the piece is made of has, as far as nothing below gives one.
    [[nodiscard]] Rgba own_color(const Piece& piece) const {
        return !piece.color.given() && tree_.node(piece.node).operation == Operation::Color ? tree_.color(piece.node)
                                                                                            : piece.color;
    }
    /// Is all that the piece is made of of one color that is seen through?
    [[nodiscard]] bool begins_translucent(const Piece& piece) const {
        const Rgba color = own_color(piece);
        return color.translucent() && (color.given() || colors_below_[piece.node] == 0);
    }
    /// Is some of it?
    [[nodiscard]] bool holds_translucent(const Piece& piece) const {
        const Rgba color = own_color(piece);
        return !color.given() && (color.translucent() || translucent_below_[piece.node] != 0);
    }

    [[nodiscard]] bool is_whole(const Piece& piece, unsigned divisions) const {
        switch (rule_.kind) {
            case PartRule::Kind::Model:
                return true;
            case PartRule::Kind::Depth:
                return divisions == 0;
            case PartRule::Kind::Color:
                return piece.color.given() || tints_[piece.node].kind != Tint::Kind::Several;
            case PartRule::Kind::Module:
                return is_named_[piece.node] != 0 || holds_named_[piece.node] == 0;
        }
        return true;
    }

    /// The part that the piece belongs to as a whole; a new one, where there is none yet.
    [[nodiscard]] std::size_t plan_for(const Piece& piece, PartKind kind) {
        const PartRule::Kind rule = rule_.kind;
        const bool own = rule == PartRule::Kind::Depth ||
                         (rule == PartRule::Kind::Module && is_named_[piece.node] != 0) ||
                         (rule == PartRule::Kind::Model && kind == PartKind::Translucent);
        if (own) {
            plans_.push_back({kind, walk_.name_of(piece), {}});
            return plans_.size() - 1;
        }
        const bool colored = rule == PartRule::Kind::Color;
        const Rgba color = kind == PartKind::Translucent ? own_color(piece) : colored ? color_of(piece) : Rgba{};
        const auto [known, added] = plan_of_.try_emplace({kind, color.r, color.g, color.b, color.a}, plans_.size());
        if (added) {
            plans_.push_back({kind,
                              rule == PartRule::Kind::Model ? "model"
                              : !colored                    ? "rest"
                              : color.given()               ? color_name(color)
                                                            : "uncolored",
                              {}});
        }
        return known->second;
    }

    [[nodiscard]] Rgba color_of(const Piece& piece) const {
        return piece.color.given() ? piece.color : tints_[piece.node].color;
    }

    /// The index of the first child that counts; the number of children where there is none.
    [[nodiscard]] std::uint32_t first_operand(NodeId id) const {
        const auto children = tree_.children(id);
        const auto counts = [&](NodeId child) { return !walk_.is_left_out(child); };
        const auto found = std::find_if(children.begin(), children.end(), counts);
        return found == children.end() || (!walk_.is_union(id) && walk_.dimension(*found) == Dimension::None)
                   ? static_cast<std::uint32_t>(children.size())
                   : static_cast<std::uint32_t>(found - children.begin());
    }

    [[nodiscard]] bool has_several(NodeId id) const {
        const auto children = tree_.children(id);
        return std::count_if(children.begin(), children.end(), [&](NodeId child) {
                   return !walk_.is_left_out(child) && walk_.dimension(child) != Dimension::None;
               }) > 1;
    }

    /// By node, from the leaves up: `of_leaf(id)`, and `merge(id, into, child, from)` over the children that are
    /// divided.
    template <typename Value, typename OfLeaf, typename Merge>
    std::vector<Value> from_below(OfLeaf&& of_leaf, Merge&& merge) const {
        std::vector<Value> values(tree_.size());
        for (NodeId id = 0; id < tree_.size(); ++id) {  // Children stand before parents.
            if (walk_.is_leaf(id)) {
                values[id] = of_leaf(id);
                continue;
            }
            const auto children = tree_.children(id);
            const std::uint32_t first = first_operand(id);
            const std::uint32_t end = walk_.is_union(id) ? static_cast<std::uint32_t>(children.size()) : first + 1;
            for (std::uint32_t c = first; c < std::min<std::size_t>(end, children.size()); ++c) {
                if (!walk_.is_left_out(children[c])) {
                    merge(id, values[id], children[c], values[children[c]]);
                }
            }
        }
        return values;
    }

    void find_translucent() {
        translucent_below_ =
            from_below<char>([](NodeId) { return char{0}; },
                             [this](NodeId id, char& into, NodeId, char from) {
                                 const bool colors = tree_.node(id).operation == Operation::Color;
                                 const bool own = colors && tree_.color(id).translucent();
                                 into = into != 0 || own || (from != 0 && !(colors && tree_.color(id).given())) ? 1 : 0;
                             });
        colors_below_ = from_below<char>(
            [](NodeId) { return char{0}; },
            [this](NodeId, char& into, NodeId child, char from) {
                into = into != 0 || from != 0 || tree_.node(child).operation == Operation::Color ? 1 : 0;
            });
    }

    void find_tints() {
        tints_ = from_below<Tint>(
            [](NodeId) {
                return Tint{Tint::Kind::One, {}};
            },
            [this](NodeId id, Tint& into, NodeId, const Tint& from) {
                Tint tint = from;
                if (tint.kind != Tint::Kind::Nothing && tree_.node(id).operation == Operation::Color &&
                    tree_.color(id).given()) {
                    tint = {Tint::Kind::One, tree_.color(id)};
                }
                if (into.kind == Tint::Kind::Nothing) {
                    into = tint;
                } else if (tint.kind != Tint::Kind::Nothing && (tint.kind != into.kind || tint.color != into.color)) {
                    into = {Tint::Kind::Several, {}};
                }
            });
    }

    void find_modules() {
        std::vector<SourceLocation> named;
        for (const Statement& statement : tree_.statements()) {
            if (statement.user_module && std::ranges::find(rule_.modules, statement.name) != rule_.modules.end()) {
                named.push_back(statement.where);  // In order, as the statements are.
            }
        }
        is_named_.resize(tree_.size());
        for (NodeId id = 0; id < tree_.size(); ++id) {
            is_named_[id] =
                tree_.node(id).operation == Operation::Group && std::ranges::binary_search(named, tree_.node(id).where);
        }
        holds_named_ = from_below<char>([](NodeId) { return char{0}; },
                                        [this](NodeId, char& into, NodeId child, char from) {
                                            into = into != 0 || from != 0 || is_named_[child] != 0 ? 1 : 0;
                                        });
    }

    SceneWalk& walk_;
    const Tree& tree_;
    const PartRule& rule_;
    std::vector<char> translucent_below_;       ///< By node: a color that is seen through, at it or below.
    std::vector<char> colors_below_;            ///< By node: there is a color() below.
    std::vector<Tint> tints_;                   ///< By node, for the rule Color.
    std::vector<char> is_named_, holds_named_;  ///< By node, for the rule Module: it is one of them; one is below.
    std::vector<PartPlan> plans_;
    std::map<std::tuple<PartKind, float, float, float, float>, std::size_t> plan_of_;
};

}  // namespace

std::vector<PartPlan> split_parts(SceneWalk& walk, const PartRule& rule) {
    return Splitter(walk, rule).split();
}

}  // namespace csg
