// Motions that keep distances, as turns about an axis and ways along it.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace ui {

/// A turn about an axis and a way along it (Chasles): what any rigid motion is.
struct Screw {
    glm::dvec3 axis{
        0.0};  ///< Of length 1; about it the turn is counter-clockwise. Where nothing turns, that of the way.
    glm::dvec3 point{0.0};  ///< On the axis, nearest to the origin; of a way alone the origin.
    double angle = 0;       ///< Radians, 0 to π.
    double along = 0;       ///< World units along the axis; of a way alone at least 0.
};

/// Of a matrix that keeps distances and orientation; nothing of others (lengths may be off by a share of 1e-9). A turn
/// by less than 1e-8 is none.
[[nodiscard]] std::optional<Screw> screw_of(const glm::dmat4& motion);

/// The share of the screw, which may be beyond 0 and 1.
[[nodiscard]] glm::dmat4 matrix_of(const Screw& screw, double share);

/// What lies between two motions, 0 to 1: by the screw from one to the other where there is one, else entry by entry.
[[nodiscard]] glm::dmat4 between(const glm::dmat4& from, const glm::dmat4& to, double share);

}  // namespace ui
