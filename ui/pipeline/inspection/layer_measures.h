// Volume, area, centroid and moments of a model and of its parts, from layers seen along the axes: no mesh is made.
#pragma once

#include <stop_token>
#include <vector>

#include "csg/tree/box.h"
#include "ui/pipeline/model.h"

namespace ui {

/// World units, to their powers. `error`: half of what neighboring rays differ by, summed up: what may lie between
/// them. A thing that no ray meets is not counted.
struct BoundedValue {
    double value = 0, error = 0;
};

struct SolidMeasures {
    BoundedValue volume, area;
    glm::dvec3 centroid{0.0};
    double centroid_error = 0;
    /// Principal moments of inertia about the centroid at density 1, the least first.
    glm::dvec3 moments{0.0};
    double moments_error = 0;
    csg::Box box;  ///< Of what the rays met: up to a spacing too small on each side; empty where they met nothing.
};

struct LayerMeasures {
    SolidMeasures all;                 ///< Where parts overlap, once.
    std::vector<SolidMeasures> parts;  ///< By part; of `%` and `#` nothing.
    double spacing = 0;                ///< Of the rays.
};

/// With more and more rays until the errors of the whole's volume and area are at most `precision` of them, or there
/// are 2048 along the longest side. Throws base::Stopped.
[[nodiscard]] LayerMeasures measure_by_layers(const Model& model, double precision, const std::stop_token& stop = {});

}  // namespace ui
