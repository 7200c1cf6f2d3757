// The expression of a group of leaves, kept up to date as leaves are entered and left.
#pragma once

#include <span>
#include <vector>

#include "csg/tree/scene.h"

namespace csg::reference {

/// The parts that are the model: solid and translucent ones.
[[nodiscard]] std::vector<PartId> solid_parts(const Scene& scene);

/// Operations over the leaves of a group, as parents only. What is missing of an operation's children is empty.
struct GroupExpression {
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    struct Node {
        ExpressionKind kind = ExpressionKind::Union;
        std::uint32_t parent = kNone;  ///< The root has none.
        std::uint32_t children = 0;    ///< In the scene: of an intersection all must be true.
        bool first = false;            ///< What a difference is taken from.
        bool complement = false;       ///< Below an odd number of subtractions.
    };
    std::vector<Node> nodes;
    std::vector<std::uint32_t> leaves;  ///< Their nodes.
};

class ExpressionValue {
  public:
    /// Outside of all leaves. Keeps the reference.
    explicit ExpressionValue(const GroupExpression& expression);

    /// Enters or leaves a leaf. Takes as long as there are nodes above it that change.
    void set(LeafId leaf, bool inside);
    [[nodiscard]] bool value() const { return value_; }

    /// Of the sorted leaves that switch, the one whose surface it is (docs/ENGINES.md, "Whose surface it is"), asked on
    /// the side where the solid is.
    [[nodiscard]] LeafId owner(std::span<const LeafId> switching) const;

  private:
    struct State {
        std::uint32_t entered = 0;  ///< Of the children, but for what a difference is taken from.
        bool first = false;
        bool value = false;
    };
    [[nodiscard]] bool evaluate(std::uint32_t node) const;

    const GroupExpression& expression_;
    std::vector<State> states_;
    bool value_ = false;
};

}  // namespace csg::reference
