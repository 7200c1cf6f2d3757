// Models with defects of known size: what csgscope check must find, and models without, where it must find nothing.
#pragma once

#include <string>
#include <vector>

#include "ui/pipeline/inspection/findings.h"

namespace test {

struct Defect {
    ui::FindingKind kind = ui::FindingKind::Wall;
    std::string text;                   ///< A statement to put behind the sound model's, or …
    std::string cut;                    ///< … what to subtract from its box.
    double value = -1;                  ///< That is to be told, world units; below 0: none.
    std::vector<ui::FindingKind> also;  ///< Other kinds that it is, too.
};

/// The sound model of a seed, turned at random, with the defects put into it: a box with a pocket and a hole, a wedge
/// of 31 degrees, a cone, two bodies that overlap well.
[[nodiscard]] std::string seeded_model(unsigned seed, const std::vector<Defect>& defects);

/// One of each kind but overhangs and sizes. Faces of defects hold a disc of radius `reach`, and not much more.
[[nodiscard]] std::vector<Defect> defects_of(unsigned seed, double reach);

/// The limits to which the sound models keep.
inline constexpr double kLeastWall = 1, kLeastGap = 0.8, kLeastFeature = 1, kLeastClearance = 1.5;

}  // namespace test
