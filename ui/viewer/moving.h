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

/// How many leaves there are at and below the occurrence.
[[nodiscard]] std::size_t leaves_below(const csg::Scene& scene, csg::OccurrenceId occurrence);
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
    HeldPart held;             ///< Where it was put, or turned, scaled, stretched.
    std::size_t leaves = 1;    ///< That are held.
};
struct MoveAnswer {
    std::string text;           ///< Before any of them.
    std::vector<MoveWay> ways;  ///< The best first.
    std::string what;
    HeldPart held;
    std::string trouble;  ///< For people: why there are none.
};

/// What a hand has done, for people.
struct Gesture {
    std::string verb;  ///< "move", "turn", "scale", "stretch"
    std::string told;  ///< "moved by [1, 2, 0]"
};
[[nodiscard]] Gesture gesture_of(const HeldPart& held);

using FindWays = std::function<MoveAnswer(const MoveQuestion&, const std::stop_token&)>;

/// Never throws; an answer of no worth where it was stopped.
[[nodiscard]] FindWays make_find_ways();

}  // namespace ui
