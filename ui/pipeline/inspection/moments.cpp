#include "ui/pipeline/inspection/moments.h"

#include <algorithm>
#include <cmath>

namespace ui {

void MomentSums::add_segment(const glm::dvec3& start, const glm::dvec3& direction, double length, double side) {
    const double prism = length * side * side;
    const glm::dvec3 middle = start + 0.5 * length * direction;
    volume += prism;
    first += prism * middle;
    const glm::dmat3 along = glm::outerProduct(direction, direction);
    second += prism * (glm::outerProduct(middle, middle) + length * length / 12 * along +
                       side * side / 12 * (glm::dmat3(1.0) - along));
}

/// Eigenvalues by Jacobi's rotations.
glm::dvec3 principal_moments(const MomentSums& sums, const glm::dvec3& centroid) {
    const glm::dmat3 about = sums.second - sums.volume * glm::outerProduct(centroid, centroid);
    glm::dmat3 m = (about[0][0] + about[1][1] + about[2][2]) * glm::dmat3(1.0) - about;
    constexpr int kSweeps = 12;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (int p = 0; p < 2; ++p) {
            for (int q = p + 1; q < 3; ++q) {
                if (m[p][q] == 0) {
                    continue;
                }
                const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
                const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1));
                const double c = 1 / std::sqrt(t * t + 1), s = t * c;
                glm::dmat3 turn(1.0);
                turn[p][p] = turn[q][q] = c;
                turn[p][q] = -s;
                turn[q][p] = s;
                m = glm::transpose(turn) * m * turn;
            }
        }
    }
    glm::dvec3 values(m[0][0], m[1][1], m[2][2]);
    std::sort(&values.x, &values.x + 3);
    return values;
}

}  // namespace ui
