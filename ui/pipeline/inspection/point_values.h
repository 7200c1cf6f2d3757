// The values of a scene's expressions at one point after another, each by the few leaves that hold it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csg/tree/scene.h"

namespace ui {

/// What does not change from point to point: shared by all threads.
struct ExpressionLinks {
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    explicit ExpressionLinks(const csg::Scene& scene);

    const csg::Scene& scene;            ///< Must outlive it.
    std::vector<std::uint32_t> parent;  ///< By expression; kNone of roots.
    std::vector<char> first;            ///< By expression: is it its parent's first child?
    std::vector<std::uint32_t> of_leaf;
    std::vector<csg::PartId> part;  ///< By expression.
};

/// Where no leaf holds a point, all expressions are false there; so only those above the leaves that do are looked at.
class PointValues {
  public:
    explicit PointValues(const ExpressionLinks& links);

    /// Goes to the point that just these leaves hold; each is named once.
    void go(std::span<const csg::LeafId> inside);

    [[nodiscard]] bool value(std::uint32_t expression) const { return at_[expression].value; }
    [[nodiscard]] bool in_part(csg::PartId part) const { return value(links_.scene.parts[part].root); }
    /// The parts that hold the point, by id.
    [[nodiscard]] const std::vector<csg::PartId>& parts() const { return parts_; }

    /// Expressions with a child that is true, children before parents; leaves that hold the point are among them.
    [[nodiscard]] const std::vector<std::uint32_t>& touched() const { return touched_; }
    /// Of one of them: how many children are true, whether the first is, and the sum of their indices: with one, which.
    struct Node {
        std::uint32_t true_children = 0;
        std::uint64_t sum = 0;
        bool first = false, value = false;
    };
    [[nodiscard]] const Node& node(std::uint32_t expression) const { return at_[expression]; }
    [[nodiscard]] const ExpressionLinks& links() const { return links_; }

  private:
    const ExpressionLinks& links_;
    std::vector<Node> at_;
    std::vector<std::uint32_t> heap_, touched_;
    std::vector<csg::PartId> parts_;
};

}  // namespace ui
