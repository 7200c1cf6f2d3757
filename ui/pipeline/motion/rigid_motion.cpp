#include "ui/pipeline/motion/rigid_motion.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// A smaller turn is told by rounding no better than by leaving it out.
constexpr double kRigid = 1e-9, kNoTurn = 1e-8;

/// Of a turn by nearly half a turn: from the matrix R = 2 a aᵀ − 1, by its largest column.
glm::dvec3 axis_of_half_turn(const glm::dmat3& r) {
    const glm::dmat3 outer = 0.5 * (r + glm::transpose(r));
    int best = 0;
    for (int i = 1; i < 3; ++i) {
        best = outer[i][i] > outer[best][best] ? i : best;
    }
    glm::dvec3 column = outer[best];
    column[best] += 1;
    return glm::normalize(column);
}

}  // namespace

std::optional<Screw> screw_of(const glm::dmat4& motion) {
    const glm::dmat3 r(motion);
    const glm::dmat3 product = r * glm::transpose(r);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if (!(std::abs(product[i][j] - (i == j ? 1 : 0)) <= kRigid)) {
                return {};
            }
        }
    }
    if (glm::determinant(r) < 0) {
        return {};
    }
    const glm::dvec3 way(motion[3]);
    // Twice the sine times the axis, and twice the cosine plus 1: together they tell small and large angles well.
    const glm::dvec3 sine(r[1][2] - r[2][1], r[2][0] - r[0][2], r[0][1] - r[1][0]);
    const double trace = r[0][0] + r[1][1] + r[2][2];
    Screw screw;
    screw.angle = std::atan2(glm::length(sine), trace - 1);
    if (screw.angle < kNoTurn) {
        screw.angle = 0;
        screw.along = glm::length(way);
        screw.axis = screw.along > 0 ? way / screw.along : glm::dvec3(0, 0, 1);
        return screw;
    }
    if (glm::length(sine) > 1e-6) {
        screw.axis = glm::normalize(sine);
    } else {
        screw.axis = axis_of_half_turn(r);
        if (glm::dot(screw.axis, sine) < 0) {
            screw.axis = -screw.axis;
        }
    }
    screw.along = glm::dot(way, screw.axis);
    const glm::dvec3 aside = way - screw.along * screw.axis;
    screw.point = 0.5 * (aside + glm::cross(screw.axis, aside) / std::tan(screw.angle / 2));
    return screw;
}

glm::dmat4 matrix_of(const Screw& screw, double share) {
    const double angle = share * screw.angle, c = std::cos(angle), s = std::sin(angle);
    const glm::dvec3& a = screw.axis;
    const glm::dmat3 turn(c + (1 - c) * a.x * a.x, (1 - c) * a.x * a.y + s * a.z, (1 - c) * a.x * a.z - s * a.y,
                          (1 - c) * a.x * a.y - s * a.z, c + (1 - c) * a.y * a.y, (1 - c) * a.y * a.z + s * a.x,
                          (1 - c) * a.x * a.z + s * a.y, (1 - c) * a.y * a.z - s * a.x, c + (1 - c) * a.z * a.z);
    glm::dmat4 result(turn);
    result[3] = glm::dvec4(screw.point - turn * screw.point + share * screw.along * a, 1);
    return result;
}

glm::dmat4 between(const glm::dmat4& from, const glm::dmat4& to, double share) {
    if (std::abs(glm::determinant(glm::dmat3(from))) > 0) {
        if (const auto screw = screw_of(to * glm::inverse(from))) {
            return matrix_of(*screw, share) * from;
        }
    }
    return from * (1 - share) + to * share;
}

}  // namespace ui
