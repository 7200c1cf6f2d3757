// How many of a model's solids can be moved by hand.
#pragma once

#include <optional>

#include "ui/pipeline/editing/move_leaf.h"

namespace ui {

struct MovableSurvey {
    struct Solid {
        csg::LeafId leaf = 0;
        std::optional<MoveWay> way;  ///< That of Ways::First.
        std::string why;             ///< There is none.
    };
    std::vector<Solid> solids;
    std::size_t all = 0;  ///< Of the model.
};

/// Of `count` leaves, evenly spread, or of all where there are fewer; the rest as ways_to_move.
[[nodiscard]] MovableSurvey survey_movable(const csg::Tree& tree, const csg::Scene& scene,
                                           const csg::scad::LoadedProgram& program, const std::string& text,
                                           std::size_t count, const glm::dvec3& by, const TreeOfText& tree_of,
                                           const std::stop_token& stop = {});

}  // namespace ui
