// Where an outline is a curve and where it has corners. Internal to csg/solid.
#pragma once

#include <vector>

#include "csg/solid/outline.h"
#include "csg/solid/smooth_groups.h"

namespace csg::solid {

/// The curve that each edge of an outline belongs to, by loop and the edge's first corner, as the group of the wall on
/// it; with the largest angle to an edge beside it on the curve.
struct OutlineCurves {
    std::vector<std::vector<FacetGroup>> edges;
    std::uint32_t count = 0;  ///< Of curves.
};

/// Corners of an outline that stand for points of a curve are told by their row: at least three angles of one sign that
/// change slowly, none above kMostBend, with edges about equally long between them. What bends less than kLeastCrease
/// is no corner either.
[[nodiscard]] OutlineCurves curves_of(const Outline& outline);

/// The same for an outline that `divided` has more corners of, on the edges of `outline`.
[[nodiscard]] OutlineCurves curves_of(const Outline& outline, const Outline& divided);

}  // namespace csg::solid
