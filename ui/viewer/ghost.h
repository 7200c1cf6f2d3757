// The shapes below a call as they are before others cut them: seen through everything, over the picture.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "ui/pipeline/model.h"

namespace ui {

/// World coordinates.
struct Ghost {
    std::vector<std::array<glm::dvec3, 3>> triangles;        ///< Counterclockwise as seen from outside.
    std::vector<std::pair<glm::dvec3, glm::dvec3>> creases;  ///< Edges between faces that are no smooth surface.
    bool cuts = false;                                       ///< What it is of is taken away from something.
};

/// Of the leaves that are the occurrence, or below it. Nothing of kNoOccurrence, and where there are more than
/// `most` triangles.
[[nodiscard]] Ghost ghost_of(const Model& model, csg::OccurrenceId occurrence, std::size_t most = 50'000);

}  // namespace ui
