// What has been moved by hand, as an edit of the text: found on a thread of its own.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <tuple>
#include <vector>

#include "ui/pipeline/editable_model.h"
#include "ui/pipeline/editing/move_leaf.h"
#include "ui/viewer/revision.h"

namespace ui {

/// A leaf as it is known in every tree of one text, also where parts of that are hidden.
struct LeafName {
    std::vector<std::tuple<std::string, std::uint32_t, std::uint32_t>> calls;  ///< File, line and column, root first.
    glm::dmat4 to_world{1.0};
    bool operator==(const LeafName&) const = default;
};
[[nodiscard]] LeafName name_of(const csg::Tree& tree, const csg::Scene& scene, csg::LeafId leaf);

/// The first leaf at or below the occurrence; as many leaves as there are where there is none.
[[nodiscard]] csg::LeafId first_leaf_below(const csg::Scene& scene, csg::OccurrenceId occurrence);
/// The box of the leaves at and below it.
[[nodiscard]] csg::Box box_below(const Model& model, csg::OccurrenceId occurrence);

struct MoveQuestion {
    Source source;  ///< With the text that is to be edited.
    csg::scad::View camera;
    std::string text;  ///< That one.
    LeafName leaf;
    csg::SourceLocation call;  ///< Of what is moved, which the leaf is of or below; its `file` does not count.
    std::string what;          ///< "cube"
    glm::dvec3 by{0.0};
    glm::dvec3 turn{0.0};  ///< Instead, where it is not zero: as ways_to_turn() has it.
};
struct MoveAnswer {
    std::string text;           ///< Before any of them.
    std::vector<MoveWay> ways;  ///< The best first.
    std::string what;
    glm::dvec3 by{0.0};
    std::string trouble;  ///< For people: why there are none.
    glm::dvec3 turn{0.0};
};
using FindWays = std::function<MoveAnswer(const MoveQuestion&, const std::stop_token&)>;

/// Never throws; an answer of no worth where it was stopped.
[[nodiscard]] FindWays make_find_ways();

}  // namespace ui
