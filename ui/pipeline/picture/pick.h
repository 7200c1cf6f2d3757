// What lies behind a pixel: which surfaces, of what, and from where in the text.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "base/camera.h"
#include "layers/host_stack.h"
#include "ui/pipeline/model.h"

namespace ui {

struct PickedSurface {
    int layer = 0;            ///< 0 is the nearest.
    layers::Surface surface;  ///< As the stack holds it: the leaf that made the face among the rest.
    double distance = 0;      ///< World units; from the eye (perspective) or from its plane (orthographic).
    glm::dvec3 point{0.0};    ///< World coordinates.
    glm::dvec3 normal{0.0};   ///< Of length 1, away from the part's material.
    csg::PartId part = 0;
    csg::OccurrenceId occurrence = csg::kNoOccurrence;  ///< Of the leaf.
    /// The parts that hold the points just in front of it and just behind it, as far as all layers are known that the
    /// ray meets; `#` parts, which are others once more, do not count.
    std::vector<csg::PartId> in_front, behind;
};

/// The camera whose picture of one pixel is that around `cursor` (pixels from the upper left corner, fractions counted)
/// in the camera's picture of `size`.
[[nodiscard]] base::Camera pixel_camera(const base::Camera& camera, glm::ivec2 size, glm::dvec2 cursor);

/// The surfaces of a view of one pixel, nearest first.
[[nodiscard]] std::vector<PickedSurface> picked(const Model& model, const base::View& view,
                                                const layers::HostStack& stack);

}  // namespace ui
