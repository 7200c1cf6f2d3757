// Triangles on the screen for the rasterizer on the CPU: clipped, and snapped to a grid on which all is exact.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/camera.h"
#include "csg/solid/placed.h"

namespace goldfeather {

/// Bits behind the point of a snapped coordinate: a vertex moves by at most 2⁻¹⁵ pixel in x and in y. With at most
/// 2¹⁵ pixels of range an edge function stays below 2⁵⁹: 64-bit integers hold it exactly.
inline constexpr int kSubpixelBits = 14;
inline constexpr std::int64_t kSubpixels = std::int64_t{1} << kSubpixelBits;

/// Counter-clockwise on the screen, with an area; coordinates in 1/kSubpixels pixel from the lower left corner, sample
/// jitter taken off, so that samples lie at pixel centers.
struct ScreenTriangle {
    std::array<std::int32_t, 3> x{}, y{};
    std::uint32_t leaf_and_side = 0;  ///< As in Fragment.
    std::uint32_t plane = 0;
    double farthest = 0, nearest = 1;  ///< Between which (reversed) depths the surface lies.
};

/// Projects the triangles of a leaf, clips them at the near plane and far outside the picture, and adds to `out` what
/// may cover a sample. An edge that two triangles share is clipped and snapped alike for both, so that every sample is
/// covered by just one of two triangles that meet there.
void project_leaf(const csg::solid::PlacedLeaf& leaf, csg::LeafId id, const base::View& view,
                  std::vector<ScreenTriangle>& out);

/// Can the near plane cut the box?
[[nodiscard]] bool near_plane_cuts(const base::View& view, const csg::Box& box);

}  // namespace goldfeather
