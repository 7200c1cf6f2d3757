#include "ui/pipeline/editing/movable_survey.h"

#include <algorithm>

namespace ui {

MovableSurvey survey_movable(const csg::Tree& tree, const csg::Scene& scene, const csg::scad::LoadedProgram& program,
                             const std::string& text, std::size_t count, const glm::dvec3& by,
                             const TreeOfText& tree_of, const std::stop_token& stop) {
    MovableSurvey survey;
    survey.all = scene.leaves.size();
    count = std::min(count, survey.all);
    for (std::size_t i = 0; i < count; ++i) {
        MovableSurvey::Solid solid;
        solid.leaf = static_cast<csg::LeafId>((2 * i + 1) * survey.all / (2 * count));
        std::vector<MoveWay> ways =
            ways_to_move(tree, scene, program, text, solid.leaf, by, tree_of, stop, Ways::First);
        if (ways.empty()) {
            solid.why = why_no_way(tree, scene, program, text, solid.leaf, tree_of);
        } else {
            solid.way = std::move(ways.front());
        }
        survey.solids.push_back(std::move(solid));
    }
    return survey;
}

}  // namespace ui
