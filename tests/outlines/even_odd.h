// What loops enclose by the even-odd rule, from the definition.
#pragma once

#include <optional>
#include <vector>

#include "csg/solid/outline.h"

namespace outlines {

struct Moments {
    double area = 0;
    double x = 0;  ///< The integral of x over the region.
};

/// By strips between all x where something ends or crosses; in time of the square of the edges and more.
[[nodiscard]] Moments even_odd_moments(const std::vector<csg::solid::Loop>& loops);

/// Nothing nearer than `margin` to an edge.
[[nodiscard]] std::optional<bool> is_inside(const std::vector<csg::solid::Loop>& loops, const glm::dvec2& p,
                                            double margin);

[[nodiscard]] double distance_to_edges(const std::vector<csg::solid::Loop>& loops, const glm::dvec2& p);

}  // namespace outlines
