// Triangles to pixels in double precision, without clipping.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/camera.h"

namespace npr {

/// A corner in homogeneous pixels: (x, y, w), from the sample's place.
using RasterCorner = glm::dvec3;

[[nodiscard]] inline RasterCorner raster_corner(const base::View& view, const glm::dvec3& in_eye) {
    const double scale = view.size().y / (2 * view.half_height());
    const double w = view.orthographic() ? 1.0 : -in_eye.z;
    const glm::dvec2 middle = 0.5 * glm::dvec2(view.size()) - view.jitter();
    return {in_eye.x * scale + middle.x * w, in_eye.y * scale + middle.y * w, w};
}

/// Is the sample on the left of a → b? The same for both triangles at an edge, so that it belongs to one of them.
[[nodiscard]] inline bool left_of(const RasterCorner& a, const RasterCorner& b, const glm::dvec3& sample) {
    if (std::array{b.x, b.y, b.z} < std::array{a.x, a.y, a.z}) {
        return !left_of(b, a, sample);
    }
    const glm::dvec3 line = glm::cross(a, b);
    const double side = glm::dot(sample, line);
    return side != 0 ? side > 0 : line.x != 0 ? line.x > 0 : line.y > 0;
}

/// Calls fragment(x, y, distance) for each pixel whose sample sees the triangle before the eye; distance is that of
/// base::View. `eye`: corners in eye coordinates, `at`: the same as raster_corner has them.
template <typename Fragment>
void rasterize(const base::View& view, const std::array<glm::dvec3, 3>& eye, const std::array<RasterCorner, 3>& at,
               const Fragment& fragment) {
    glm::dvec2 lo(0), hi(view.size());
    if (at[0].z > 0 && at[1].z > 0 && at[2].z > 0) {
        const glm::dvec2 p(at[0] / at[0].z), q(at[1] / at[1].z), r(at[2] / at[2].z);
        lo = glm::max(lo, glm::floor(glm::min(p, glm::min(q, r)) - 1.0));
        hi = glm::min(hi, glm::ceil(glm::max(p, glm::max(q, r)) + 1.0));
    } else if (at[0].z <= 0 && at[1].z <= 0 && at[2].z <= 0) {
        return;
    }
    const glm::dvec3 normal = glm::cross(eye[1] - eye[0], eye[2] - eye[0]);
    const double offset = glm::dot(normal, eye[0]);
    const double a_pixel = 2 * view.half_height() / view.size().y;
    for (int y = static_cast<int>(lo.y); y < static_cast<int>(hi.y); ++y) {
        for (int x = static_cast<int>(lo.x); x < static_cast<int>(hi.x); ++x) {
            const glm::dvec3 sample(x + 0.5, y + 0.5, 1.0);
            const bool first = left_of(at[0], at[1], sample);
            if (first != left_of(at[1], at[2], sample) || first != left_of(at[2], at[0], sample)) {
                continue;
            }
            const glm::dvec2 on_plane = (glm::dvec2(sample) - 0.5 * glm::dvec2(view.size()) + view.jitter()) * a_pixel;
            const double distance = view.orthographic()
                                        ? -(offset - normal.x * on_plane.x - normal.y * on_plane.y) / normal.z
                                        : offset / (normal.x * on_plane.x + normal.y * on_plane.y - normal.z);
            if (std::isfinite(distance) && distance >= view.near_distance()) {
                fragment(x, y, distance);
            }
        }
    }
}

}  // namespace npr
