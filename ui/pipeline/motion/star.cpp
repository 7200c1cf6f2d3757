#include "ui/pipeline/motion/star.h"

#include <array>
#include <cstdint>

namespace ui {

namespace {

/// A point of the cube from -1 to 1 in thirds on the sphere, spikes where all coordinates are -1, 0 or 1 but valleys.
struct Surface {
    static constexpr int kSteps = 4;  ///< Quads along an edge of the cube; every other corner is the tip of a spike.
    csg::Polyhedron mesh;
    std::array<std::int32_t, (kSteps + 1) * (kSteps + 1) * (kSteps + 1)> known{};

    std::uint32_t corner(const glm::ivec3& at, const glm::dvec3& middle, double radius) {
        std::int32_t& index = known[static_cast<std::size_t>((at.x * (kSteps + 1) + at.y) * (kSteps + 1) + at.z)];
        if (index == 0) {
            const glm::dvec3 out = glm::dvec3(at) / (0.5 * kSteps) - 1.0;
            const int odd = at.x % 2 + at.y % 2 + at.z % 2;
            constexpr double kValley = 0.33, kShort = 0.72;
            const bool edge = out.x == 0 || out.y == 0 || out.z == 0;
            const bool face = (out.x == 0) + (out.y == 0) + (out.z == 0) == 2;
            const double far = odd > 0 ? kValley : edge && !face ? kShort : 1;
            mesh.points.push_back(middle + far * radius * glm::normalize(out));
            index = static_cast<std::int32_t>(mesh.points.size());
        }
        return static_cast<std::uint32_t>(index - 1);
    }
};

}  // namespace

csg::Polyhedron star(const glm::dvec3& middle, double radius) {
    Surface surface;
    constexpr int n = Surface::kSteps;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, n}) {
            for (int u = 0; u < n; ++u) {
                for (int v = 0; v < n; ++v) {
                    const auto at = [&](int du, int dv) {
                        glm::ivec3 p;
                        p[axis] = side;
                        p[(axis + 1) % 3] = u + du;
                        p[(axis + 2) % 3] = v + dv;
                        return surface.corner(p, middle, radius);
                    };
                    std::array<std::uint32_t, 4> quad{at(0, 0), at(0, 1), at(1, 1), at(1, 0)};
                    if (side == 0) {
                        std::swap(quad[1], quad[3]);
                    }
                    // Along the diagonal between valleys, so that ridges run from tip to tip over the spikes.
                    if ((u + v) % 2 == 0) {
                        surface.mesh.faces.push_back({quad[0], quad[1], quad[3]});
                        surface.mesh.faces.push_back({quad[1], quad[2], quad[3]});
                    } else {
                        surface.mesh.faces.push_back({quad[0], quad[1], quad[2]});
                        surface.mesh.faces.push_back({quad[0], quad[2], quad[3]});
                    }
                }
            }
        }
    }
    return std::move(surface.mesh);
}

}  // namespace ui
