#include "goldfeather/products.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace goldfeather {
namespace {

using csg::Box;
using csg::Expression;
using csg::ExpressionKind;
using csg::LeafId;

constexpr double kSaturated = 1e18;
/// Partial products looked at for each product allowed, before the budget counts as passed.
constexpr std::size_t kStatesPerProduct = 64;
/// Literals and factors looked at, and those that wait at one time, for each literal allowed.
constexpr std::size_t kWorkPerLiteral = 64, kWaitingPerLiteral = 16;
/// Boxes count as apart only beyond the rounding of coordinates: a face that touches keeps its complement, for it
/// may give the surface its color.
constexpr double kTouching = 0x1p-32;

/// An expression that a product still has to be multiplied with.
struct Factor {
    std::uint32_t expression = 0;
    bool complement = false;
};

/// A partial product: literals found, factors still to be rewritten.
struct State {
    std::vector<Literal> literals;
    std::vector<Factor> pending;
    Box box{glm::dvec3(-std::numeric_limits<double>::infinity()), glm::dvec3(std::numeric_limits<double>::infinity())};
};

bool has_volume(const Box& box) {
    return box.lo.x < box.hi.x && box.lo.y < box.hi.y && box.lo.z < box.hi.z;
}

/// Can there be a surface where an expression, whose box is `own`, meets what `shared` is the box of? Where boxes only
/// touch there is none; but polyhedra that are flat themselves, and open, are seen.
bool may_show(const Box& shared, const Box& own) {
    return has_volume(shared) || (!shared.empty() && !has_volume(own));
}

bool strictly_apart(const Box& a, const Box& b) {
    if (a.empty() || b.empty()) {
        return true;
    }
    const glm::dvec3 largest =
        glm::max(glm::max(glm::abs(a.lo), glm::abs(a.hi)), glm::max(glm::abs(b.lo), glm::abs(b.hi)));
    const double margin = kTouching * std::max({largest.x, largest.y, largest.z});
    return a.hi.x + margin < b.lo.x || b.hi.x + margin < a.lo.x || a.hi.y + margin < b.lo.y ||
           b.hi.y + margin < a.lo.y || a.hi.z + margin < b.lo.z || b.hi.z + margin < a.lo.z;
}

/// How many products each expression and its complement would give without pruning.
double count_unpruned(const csg::Scene& scene, const csg::Part& part) {
    struct Count {
        double plain = 0, complement = 0;
    };
    std::vector<Count> counts(part.root - part.first_expression + 1);
    for (std::uint32_t i = part.first_expression; i <= part.root; ++i) {
        const Expression& e = scene.expressions[i];
        Count& count = counts[i - part.first_expression];
        if (e.kind == ExpressionKind::Leaf) {
            count = {1, 1};
            continue;
        }
        // A union adds where its complement multiplies; the other kinds the other way around.
        const bool sum = e.kind == ExpressionKind::Union;
        double added = 0, multiplied = 1;
        bool first = true;
        for (const std::uint32_t child : scene.children(e)) {
            Count c = counts[child - part.first_expression];
            if (e.kind == ExpressionKind::Difference && !first) {
                std::swap(c.plain, c.complement);
            }
            added = std::min(kSaturated, added + (sum ? c.plain : c.complement));
            multiplied = std::min(kSaturated, multiplied * (sum ? c.complement : c.plain));
            first = false;
        }
        count = sum ? Count{added, multiplied} : Count{first ? 0 : multiplied, first ? 1 : added};
    }
    return counts.back().plain;
}

class Rewriter {
  public:
    Rewriter(const csg::Scene& scene, const csg::Part& part, std::span<const Box> leaf_boxes, NormalizationStats& stats)
        : scene_(scene),
          part_(part),
          leaf_boxes_(leaf_boxes),
          stats_(stats),
          boxes_(csg::expression_boxes(scene, part, leaf_boxes)) {}

    Normalized run(const Budget& budget) {
        State start;
        start.pending.push_back({part_.root, false});
        std::vector<State> states;
        waiting_ = size(start);
        states.push_back(std::move(start));
        std::vector<Product> products;
        std::size_t literals = 0, looked_at = 0, work = 0;
        most_waiting_ = kWaitingPerLiteral * budget.literals;
        while (!states.empty()) {
            if (++looked_at > kStatesPerProduct * budget.products || work > kWorkPerLiteral * budget.literals ||
                waiting_ > most_waiting_) {
                return OverBudget{products.size()};
            }
            State state = std::move(states.back());
            states.pop_back();
            waiting_ -= size(state);
            work += size(state);
            std::optional<Factor> fork;
            if (!expand(state, fork)) {
                ++stats_.pruned_products;
                continue;
            }
            if (fork) {
                push_alternatives(std::move(state), *fork, states);
                continue;
            }
            products.push_back(finish(std::move(state)));
            literals += products.back().literals.size();
            if (products.size() > budget.products || literals > budget.literals) {
                return OverBudget{products.size()};
            }
        }
        if (products.empty()) {
            return Empty{};
        }
        std::sort(products.begin(), products.end(),
                  [](const Product& a, const Product& b) { return a.literals < b.literals; });
        products.erase(std::unique(products.begin(), products.end(),
                                   [](const Product& a, const Product& b) { return a.literals == b.literals; }),
                       products.end());
        stats_.products += products.size();
        for (const Product& product : products) {
            stats_.literals += product.literals.size();
        }
        return SumOfProducts{std::move(products)};
    }

  private:
    static std::size_t size(const State& state) { return state.literals.size() + state.pending.size(); }

    const Box& box_of(std::uint32_t expression) const { return boxes_[expression - part_.first_expression]; }

    /// A factor that is a choice between alternatives: a union, or the complement of an intersection or difference.
    bool forks(const Factor& factor) const {
        const Expression& e = scene_.expressions[factor.expression];
        return e.kind != ExpressionKind::Leaf && (e.kind == ExpressionKind::Union) != factor.complement;
    }

    /// Multiplies all factors in that are no choice; `fork` is the choice to go on with, if any. False where the
    /// product is known to be empty.
    bool expand(State& state, std::optional<Factor>& fork) {
        // Factors that stay for later: choices, and complements until the box is as small as it gets.
        std::vector<Factor> work = std::move(state.pending), choices, complements;
        while (!work.empty()) {
            const Factor factor = work.back();
            work.pop_back();
            const Expression& e = scene_.expressions[factor.expression];
            if (!factor.complement) {
                const Box& own = box_of(factor.expression);
                state.box = csg::intersect(state.box, own);
                if (!may_show(state.box, own)) {
                    return false;
                }
            }
            if (forks(factor)) {
                (factor.complement ? complements : choices).push_back(factor);
            } else if (e.kind == ExpressionKind::Leaf) {
                if (factor.complement) {
                    complements.push_back(factor);
                } else {
                    state.literals.push_back({e.leaf, false});
                }
            } else {
                const auto children = scene_.children(e);
                for (std::size_t c = children.size(); c-- > 0;) {
                    work.push_back({children[c], factor.complement != (e.kind == ExpressionKind::Difference && c > 0)});
                }
                if (e.kind == ExpressionKind::Intersection && children.empty()) {
                    return false;
                }
            }
        }
        if (!choices.empty()) {
            fork = choices.back();
            choices.pop_back();
            state.pending = std::move(complements);
            state.pending.insert(state.pending.end(), choices.begin(), choices.end());
            return true;
        }
        return subtract(state, complements, fork);
    }

    /// The positive part of the product is complete: keeps the complements that can reach it.
    bool subtract(State& state, const std::vector<Factor>& complements, std::optional<Factor>& fork) {
        for (const Factor& factor : complements) {
            const Expression& e = scene_.expressions[factor.expression];
            if (strictly_apart(box_of(factor.expression), state.box)) {
                ++stats_.pruned_literals;
            } else if (e.kind == ExpressionKind::Leaf) {
                state.literals.push_back({e.leaf, true});
            } else if (!fork) {
                fork = factor;
            } else {
                state.pending.push_back(factor);
            }
        }
        std::sort(state.literals.begin(), state.literals.end());
        state.literals.erase(std::unique(state.literals.begin(), state.literals.end()), state.literals.end());
        for (std::size_t i = 1; i < state.literals.size(); ++i) {
            if (state.literals[i].leaf == state.literals[i - 1].leaf) {
                return false;  // inside and outside of one leaf
            }
        }
        return true;
    }

    /// One state for each child of a choice, the last child on top: products are sorted in the end.
    void push_alternatives(State state, const Factor& choice, std::vector<State>& states) {
        const Expression& e = scene_.expressions[choice.expression];
        const auto children = scene_.children(e);
        for (std::size_t c = 0; c < children.size() && waiting_ <= most_waiting_; ++c) {
            // not(a - b) = not a + b
            const bool complement = choice.complement != (e.kind == ExpressionKind::Difference && c > 0);
            const Box& own = box_of(children[c]);
            // NOLINTNEXTLINE(bugprone-use-after-move): it is moved with the last child only.
            if (!complement && !may_show(csg::intersect(state.box, own), own)) {
                ++stats_.pruned_products;
                continue;
            }
            State& alternative =
                c + 1 < children.size() ? states.emplace_back(state) : states.emplace_back(std::move(state));
            alternative.pending.push_back({children[c], complement});
            waiting_ += size(alternative);
        }
    }

    Product finish(State state) { return {std::move(state.literals), state.box}; }

    const csg::Scene& scene_;
    const csg::Part& part_;
    std::span<const Box> leaf_boxes_;
    NormalizationStats& stats_;
    std::vector<Box> boxes_;
    std::size_t waiting_ = 0;       ///< Literals and factors of all waiting states, …
    std::size_t most_waiting_ = 0;  ///< … and how many may be.
};

}  // namespace

Normalized normalize(const csg::Scene& scene, const csg::Part& part, std::span<const Box> leaf_boxes,
                     const Budget& budget, NormalizationStats& stats) {
    stats.products_unpruned = std::min(kSaturated, stats.products_unpruned + count_unpruned(scene, part));
    return Rewriter(scene, part, leaf_boxes, stats).run(budget);
}

}  // namespace goldfeather
