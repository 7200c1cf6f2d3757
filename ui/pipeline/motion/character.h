// What kind of motion it is (Nienhaus 2005, section 7.5).
#pragma once

#include <glm/glm.hpp>

#include "ui/pipeline/motion/motion.h"

namespace ui {

struct Character {
    enum class Kind {
        Stays,    ///< It comes, goes or changes its shape, but moves nowhere.
        Turns,    ///< About one axis that stands still.
        Slides,   ///< Along one line, without turning.
        Screws,   ///< Along one axis and about it.
        Travels,  ///< Without turning, along a curve.
        Moves,    ///< Anything else that keeps distances.
        Deforms,  ///< Its matrix scales or shears.
    };
    Kind kind = Kind::Stays;
    glm::dvec3 axis{
        0.0};  ///< Of length 1, of Turns, Slides and Screws; with the first motion, for screws with its turn.
    glm::dvec3 point{0.0};                     ///< On the axis of Turns and Screws, nearest to the origin.
    double turned = 0;                         ///< Radians, in all, there and back.
    double turned_net = 0;                     ///< About the axis, less what was turned back; of Moves it is 0.
    double turned_least = 0, turned_most = 0;  ///< Radians about the axis: how far it is from where it was at first.
    double way = 0;      ///< World units that the middle of its box went, in all; of Turns along a circle.
    double way_net = 0;  ///< Along the axis of Slides and Screws; else between the first and the last place.
    double fastest = 0;  ///< World units per unit of $t of a corner of its box between two samples, jumps left out, …
    double fastest_at = 0;  ///< … and when, in their middle.
};

/// By the screws from sample to sample.
[[nodiscard]] Character character_of(const Motion& motion, const MovingBody& body);

/// "turns", "slides", …
[[nodiscard]] const char* name(Character::Kind kind);

}  // namespace ui
