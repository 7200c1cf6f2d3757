// What a check of a model asks for, and what it finds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "csg/tree/scene.h"

namespace ui {

enum class FindingKind : std::uint8_t {
    Wall,          ///< Two roughly opposite faces of a part with little of it between them.
    Gap,           ///< The same, with little between them that is of no part.
    Feature,       ///< A pin or a hole: thin in two directions across.
    Interference,  ///< Two parts share a volume.
    Clearance,     ///< Two parts are nearer to each other than they may be.
    NoEffect,      ///< An operand that changes nothing.
    Coincident,    ///< Faces that only touch.
    Overhang,      ///< A face that looks downwards.
    Size,          ///< The model, or its volume, is too large or too small.
};

struct FindingKindInfo {
    FindingKind kind;
    const char* name;      ///< "min-wall": the option that asks for it.
    const char* headline;  ///< What is wrong, for people.
};
[[nodiscard]] const std::array<FindingKindInfo, 9>& finding_kinds();

struct Clearance {
    std::string a, b;  ///< Names of parts.
    double least = 0;  ///< World units.
};

/// What to look for. Lengths are world units (mm).
struct CheckRequest {
    std::optional<double> min_wall, min_gap, min_feature;
    std::optional<double> interference;  ///< Parts may reach so far into each other.
    std::vector<Clearance> clearances;
    bool no_effect = false, coincident = false;
    std::optional<double> max_overhang;  ///< Degrees from upright.
    std::optional<glm::dvec3> max_size;
    std::optional<double> min_volume, max_volume;
    double spacing = 0;  ///< Of samples; 0: by the size of the model.
};

struct Finding {
    FindingKind kind = FindingKind::Wall;
    std::string text;                     ///< What is wrong there, in words.
    std::optional<double> value;          ///< World units, degrees of overhangs, cubed of volumes.
    double error = 0;                     ///< The worst place there may be worse by so much, and no more.
    std::optional<double> limit;          ///< That was asked for.
    glm::dvec3 point{0.0};                ///< World coordinates.
    std::optional<glm::dvec3> direction;  ///< Of length 1: what is measured reaches from the point so far.
    std::optional<csg::PartId> part, other_part;
    std::optional<csg::LeafId> leaf, other_leaf;  ///< Whose face is there, and whose is opposite.
    csg::OccurrenceId occurrence = csg::kNoOccurrence, other_occurrence = csg::kNoOccurrence;
    std::size_t samples = 0;  ///< That found it; 0: it needed none.
};

struct CheckResult {
    std::vector<Finding> findings;  ///< By kind, the worst first.
    double spacing = 0;             ///< Of samples, world units.
    std::size_t samples = 0;
    double reach = 0;  ///< Everything that holds a disc of this radius on a face is found.
};

}  // namespace ui
