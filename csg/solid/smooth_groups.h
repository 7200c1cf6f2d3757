// Which triangles of a solid are one smooth surface: what tells a crease from a joint of two facets.
//
// Shapes know it exactly: the mantle of a cylinder is one surface, each face of a box another. Walls of extrusions
// follow the outline (outline_curves.h). For meshes that came without it, it is estimated (mesh_groups.cpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace csg::solid {

struct Solid;

/// The smooth surface of a triangle, in 32 bits. Two triangles that share an edge are smooth there where they are of
/// one surface and their stretches are not more than 1 apart. A surface has stretches where it comes back to itself in
/// a corner, as the wall of a drop does: its ends are then of stretches 0 and 2.
class FacetGroup {
  public:
    static constexpr std::uint32_t kSurfaces = 1U << 22;  ///< Numbers beyond begin anew.
    static constexpr float kStepOfBend = 0.5F;

    FacetGroup() = default;
    explicit FacetGroup(std::uint32_t surface, std::uint32_t stretch = 0)
        : bits_((surface % kSurfaces) << 2U | (stretch & 3U)) {}

    [[nodiscard]] std::uint32_t surface() const { return bits_ >> 2U & (kSurfaces - 1); }
    [[nodiscard]] std::uint32_t stretch() const { return bits_ & 3U; }
    /// Degrees: the largest angle to another triangle of its surface beside it, rounded up; 63.5 at most. So far, and
    /// half of it on either side, the triangle's normal may be from that of the surface that it stands for.
    [[nodiscard]] float bend() const { return kStepOfBend * static_cast<float>(bits_ >> 24U & 127U); }
    /// Takes the larger one.
    void bends(double degrees) {
        const double steps = std::ceil(degrees / static_cast<double>(kStepOfBend) - 1e-6);
        const auto code = static_cast<std::uint32_t>(std::clamp(steps, 0.0, 127.0));
        bits_ = (bits_ & ~(127U << 24U)) | std::max(code, bits_ >> 24U & 127U) << 24U;
    }
    /// All of it, as the table of surfaces keeps it (layers/smooth_groups.glsl).
    [[nodiscard]] std::uint32_t bits() const { return bits_; }
    bool operator==(const FacetGroup&) const = default;

  private:
    std::uint32_t bits_ = 0;
};

[[nodiscard]] inline bool smooth_between(FacetGroup a, FacetGroup b) {
    const int apart = static_cast<int>(a.stretch()) - static_cast<int>(b.stretch());
    return a.surface() == b.surface() && std::abs(apart) <= 1;
}

/// An angle between neighbors from which a row of facets is no curve any more: that of a heptagon is one, a hexagon has
/// corners.
inline constexpr double kMostBend = 52;

/// Degrees below which a bend is none, whatever made it.
inline constexpr double kLeastCrease = 3;

/// Estimates the groups of a closed or open mesh by the angles between its triangles: an edge is smooth where its angle
/// is small, or of a row of three that are about equal, of one sign and with facets about equally wide between them; or
/// where all about it is as uneven as itself. Sharp edges that lead nowhere are smooth.
void estimate_groups(Solid& solid);

}  // namespace csg::solid
