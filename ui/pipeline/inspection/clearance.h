// How near two parts come to each other, between the nearest points of their surfaces.
#pragma once

#include <optional>
#include <span>
#include <stop_token>

#include "ui/pipeline/inspection/solid_probe.h"
#include "ui/pipeline/inspection/triangle_distance.h"

namespace ui {

struct PartDistance {
    double distance = 0;
    double error = 0;  ///< It may be less by so much.
    glm::dvec3 from{0.0}, to{0.0};
    csg::LeafId leaf = 0, other_leaf = 0;
};

/// Nothing where they are `most` or more apart. By triangles of leaves, halved where their nearest points are not on
/// the parts, down to pieces of the size `least_piece`. Parts that share a volume are 0 apart.
[[nodiscard]] std::optional<PartDistance> distance_between(const SolidProbe& probe, const ExpressionLinks& links,
                                                           std::span<const csg::PartId> a,
                                                           std::span<const csg::PartId> b, double most,
                                                           double least_piece, const std::stop_token& stop);

}  // namespace ui
