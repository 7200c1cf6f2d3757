#include "goldfeather/blist.h"

#include <algorithm>
#include <utility>

namespace goldfeather {

/// Writes the rows of one part.
class Blist::Builder {
  public:
    Builder(const csg::Scene& scene, const csg::Part& part, Blist& out)
        : scene_(scene), part_(part), out_(out), nodes_(part.root - part.first_expression + 1) {}

    /// Gives the part's start.
    std::uint32_t build() {
        mark_complements();
        fold();
        const Node& root = node(part_.root);
        if (root.constant != Constant::None) {
            return root.constant == Constant::True ? kTrue : kFalse;
        }
        point();
        tour();
        return root.start;
    }

  private:
    enum class Constant : std::uint8_t { None, False, True };
    struct Node {
        bool complement = false;
        bool conjunction = false;     ///< An AND, after the complement has been moved to the leaves.
        bool in_conjunction = false;  ///< So is its parent.
        bool live = false;            ///< Some result depends on it.
        Constant constant = Constant::None;
        std::uint32_t start = 0, last = 0;  ///< Leaves below, of those that matter.
        std::uint32_t when_true = kTrue, when_false = kFalse;
        std::uint32_t group = kNone;              ///< The innermost AND that it is in, …
        std::uint32_t operand = 0, next = kTrue;  ///< … and the operand of that: where it begins, and leads when true.
    };

    [[nodiscard]] Node& node(std::uint32_t expression) { return nodes_[expression - part_.first_expression]; }

    /// Parents stand behind their children: from the back, a node is reached after its parent.
    void mark_complements() {
        for (std::uint32_t i = part_.root + 1; i-- > part_.first_expression;) {
            const csg::Expression& e = scene_.expressions[i];
            const bool complement = node(i).complement;
            node(i).conjunction = (e.kind == csg::ExpressionKind::Union) == complement;
            const auto children = scene_.children(e);
            for (std::size_t k = 0; k < children.size(); ++k) {
                const bool subtracted = e.kind == csg::ExpressionKind::Difference && k > 0;
                node(children[k]).complement = complement != subtracted;
            }
        }
    }

    /// Finds nodes without a value of their own: those that come down to a union or an intersection of nothing.
    void fold() {
        for (std::uint32_t i = part_.first_expression; i <= part_.root; ++i) {
            const csg::Expression& e = scene_.expressions[i];
            Node& n = node(i);
            if (e.kind == csg::ExpressionKind::Leaf) {
                n.start = n.last = e.leaf;
                continue;
            }
            const auto children = scene_.children(e);
            if (children.empty()) {  // Never true, whatever it is.
                n.constant = n.complement ? Constant::True : Constant::False;
                continue;
            }
            const Constant deciding = n.conjunction ? Constant::False : Constant::True;
            n.constant = n.conjunction ? Constant::True : Constant::False;
            for (const std::uint32_t child : children) {
                const Node& c = node(child);
                if (c.constant == deciding) {
                    n.constant = deciding;
                    break;
                }
                if (c.constant == Constant::None) {
                    n.start = n.constant == Constant::None ? n.start : c.start;
                    n.last = c.last;
                    n.constant = Constant::None;
                }
            }
        }
    }

    /// Where each node leads to, from the root down; writes leaves and groups.
    void point() {
        node(part_.root).live = true;
        for (std::uint32_t i = part_.root + 1; i-- > part_.first_expression;) {
            const csg::Expression& e = scene_.expressions[i];
            const Node n = node(i);
            if (!n.live) {
                continue;
            }
            if (e.kind == csg::ExpressionKind::Leaf) {
                Leaf& leaf = out_.leaves_[e.leaf];
                leaf.complement = n.complement ? 1 : 0;
                leaf.group = n.group;
                leaf.inside = n.complement ? n.when_false : n.when_true;
                outside_[e.leaf - part_.first_leaf] = n.complement ? n.when_true : n.when_false;
            } else {
                point_children(n, scene_.children(e));
            }
        }
    }

    void point_children(const Node& n, std::span<const std::uint32_t> children) {
        std::uint32_t group = n.group;
        if (n.conjunction && !n.in_conjunction) {
            group = static_cast<std::uint32_t>(out_.groups_.size());
            out_.groups_.push_back({n.start, n.last, n.when_true, n.when_false, n.group, n.operand, n.next, 0});
        }
        std::uint32_t next = n.conjunction ? n.when_true : n.when_false;
        for (std::size_t k = children.size(); k-- > 0;) {
            Node& child = node(children[k]);
            if (child.constant != Constant::None) {
                continue;
            }
            child.live = true;
            child.in_conjunction = n.conjunction;
            child.group = group;
            child.when_true = n.conjunction ? next : n.when_true;
            child.when_false = n.conjunction ? n.when_false : next;
            child.operand = n.conjunction ? child.start : n.operand;
            child.next = n.conjunction ? child.when_true : n.next;
            next = child.start;
        }
    }

    /// Numbers the forest of the outside pointers. They lead forward: from the back, a leaf is reached after the one it
    /// leads to.
    void tour() {
        const csg::LeafId first = part_.first_leaf;
        std::vector<std::uint32_t> size(part_.leaf_count, 1), next(part_.leaf_count, 0);
        for (csg::LeafId i = 0; i < part_.leaf_count; ++i) {
            if (outside_[i] < kUnreached) {
                size[outside_[i] - first] += size[i];
            }
        }
        std::uint32_t next_root = first;  // Places of the parts do not overlap.
        for (csg::LeafId i = part_.leaf_count; i-- > 0;) {
            if (outside_[i] == kUnreached) {
                continue;
            }
            Leaf& leaf = out_.leaves_[first + i];
            const bool ends = outside_[i] >= kTrue;
            std::uint32_t& place = ends ? next_root : next[outside_[i] - first];
            leaf.first = place;
            leaf.last = place + size[i] - 1;
            leaf.chain_end = ends ? outside_[i] : out_.leaves_[outside_[i]].chain_end;
            place += size[i];
            next[i] = leaf.first + 1;
        }
    }

    const csg::Scene& scene_;
    const csg::Part& part_;
    Blist& out_;
    std::vector<Node> nodes_;
    static constexpr std::uint32_t kUnreached = kTrue - 1;
    std::vector<std::uint32_t> outside_ = std::vector<std::uint32_t>(part_.leaf_count, kUnreached);
};

Blist::Blist(const csg::Scene& scene, std::vector<csg::PartId> order)
    : leaves_(scene.leaves.size()), parts_(std::move(order)) {
    for (std::uint32_t rank = 0; rank < parts_.size(); ++rank) {
        const csg::Part& part = scene.parts[parts_[rank]];
        for (csg::LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
            leaves_[leaf].rank = rank;
        }
        starts_.push_back(Builder(scene, part, *this).build());
    }
}

bool Blist::value(const Group& of, std::span<const csg::LeafId> inside) const {
    for (std::uint32_t at = of.start;;) {
        std::uint32_t next = kNone;
        for (const csg::LeafId leaf : inside) {
            const Leaf& row = leaves_[leaf];
            if (leaf >= at && leaf <= of.last && leaf < next && row.first <= leaves_[at].first &&
                leaves_[at].first <= row.last) {
                next = leaf;
            }
        }
        if (next == kNone) {
            // The chain leads to the nearer exit, or by that of the farther.
            const std::uint32_t nearer = std::min(of.when_true, of.when_false);
            if (nearer >= kTrue) {
                return leaves_[at].chain_end == of.when_true;
            }
            const bool by_nearer =
                leaves_[nearer].first <= leaves_[at].first && leaves_[at].first <= leaves_[nearer].last;
            return by_nearer == (nearer == of.when_true);
        }
        at = leaves_[next].inside;
        if (at == of.when_true || at == of.when_false) {
            return at == of.when_true;
        }
    }
}

bool Blist::value(std::uint32_t rank, std::span<const csg::LeafId> inside) const {
    const std::uint32_t start = starts_[rank];
    return start >= kTrue ? start == kTrue : value({start, kTrue - 1, kTrue, kFalse}, inside);
}

bool Blist::responsible(csg::LeafId leaf, std::span<const csg::LeafId> inside) const {
    const Leaf& row = leaves_[leaf];
    const bool holds = std::find(inside.begin(), inside.end(), leaf) != inside.end();
    if (row.first == kNone || holds == (row.complement != 0)) {
        return false;
    }
    if (row.group == kNone) {
        return true;
    }
    if (!value(groups_[row.group], inside)) {
        return false;
    }
    // Of each AND further outwards the operand that this one is in is true by now: what is left are the operands before
    // and behind it, so that no leaf is looked at twice.
    for (const Group* inner = &groups_[row.group]; inner->parent != kNone;) {
        const Group& outer = groups_[inner->parent];
        if (inner->operand != outer.start &&
            !value({outer.start, inner->operand - 1, inner->operand, outer.when_false}, inside)) {
            return false;
        }
        if (inner->next != outer.when_true &&
            !value({inner->next, outer.last, outer.when_true, outer.when_false}, inside)) {
            return false;
        }
        inner = &outer;
    }
    return true;
}

}  // namespace goldfeather
