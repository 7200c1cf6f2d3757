// Which operands of a model's operations change something.
#pragma once

#include <vector>

#include "ui/pipeline/inspection/point_values.h"

namespace ui {

/// What points have shown of the expressions of a scene. Every region in which no face lies has points of faces on its
/// border, so the points on both sides of faces show all, as far as they lie close enough.
struct Effects {
    explicit Effects(const csg::Scene& scene)
        : holds(scene.expressions.size(), 0), matters(holds), alone(scene.parts.size(), 0) {}

    std::vector<char> holds;    ///< By expression: it holds a point.
    std::vector<char> matters;  ///< By expression: without it, the operation that it is an operand of is another there.
    std::vector<char> alone;    ///< By part: it holds a point that no other part does.

    void look(const PointValues& values);
    void add(const Effects& other);

    /// Does the expression's operation make the same without it? A first operand of a difference never counts.
    [[nodiscard]] bool idle(const ExpressionLinks& links, std::uint32_t expression) const;
    /// Is it an intersection or a difference of operands that hold points, and holds none itself?
    [[nodiscard]] bool emptied(const ExpressionLinks& links, std::uint32_t expression) const;
};

/// Is it united with others, of which all are subtracted in the end, or the like?
[[nodiscard]] bool is_subtracted(const ExpressionLinks& links, std::uint32_t expression);

}  // namespace ui
