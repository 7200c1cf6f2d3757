// Where a picture may rightly differ from the truth: the errors of rasterization and of float depth, as bounds.
#pragma once

#include <array>
#include <vector>

#include "base/camera.h"
#include "csg/solid/placed.h"

namespace truth {

/// Bounds of the two errors that an engine of csgscope may make (docs/ENGINES.md).
///
/// *Position.* A vertex is rounded to 1/256 pixel in x and y, so it moves by at most √2/512 < 1/360 pixel, and so do
/// the edges between vertices; we take 1/256 pixel, which leaves 0.001 pixel for the rounding of the window transform.
/// To this comes the float transform: each of the clip coordinates X, Y, W is a sum of four products of rounded factors
/// and is wrong by at most 7 · 2⁻²⁴ · Σ|m·v|. An edge between P and Q (homogeneous, pixels) passes the sample s at the
/// distance det(s, P, Q) / |∇|; the bound of the determinant's error follows from those of P and Q. Samples nearer to
/// an edge than all that are in the band. An edge between two triangles of one leaf on one plane does not matter: both
/// sides of it are snapped alike, and depth is the same on both.
///
/// *Depth.* a·x + b·y + c in float with rounded coefficients is wrong by at most 4 · 2⁻²⁴ · (|a·x| + |b·y| + |c|); the
/// canonical plane differs from the triangle's by at most the plane table's tolerance, which the ray sees as
/// tolerance / |n·d|.
class Band {
  public:
    Band(const csg::solid::Geometry& geometry, const base::View& view);

    /// Is the sample of the pixel too near to an edge?
    [[nodiscard]] bool near_edge(int x, int y) const;

    /// Distance of the sample from the nearest edge that passes by, in pixels: for messages.
    [[nodiscard]] double edge_distance(int x, int y) const;

    /// Bound of the error of the (reversed) depth of a plane of the table in a pixel, at the distance `t` from the
    /// eye's plane. Infinite for a plane seen edge-on.
    [[nodiscard]] double depth_error(std::uint32_t plane, int x, int y, double t) const;

  private:
    struct Vertex {
        glm::dvec3 at, error;  ///< Homogeneous: x and y in pixels from the center of the picture times w, and w.
    };
    struct Edge {
        glm::dvec3 line;    ///< line · (x, y, 1): distance in pixels.
        glm::dvec3 error;   ///< error · (|x|, |y|, 1): bound of its error.
        glm::dvec2 lo, hi;  ///< Where the edge is, in pixels from the center of the picture.
    };
    [[nodiscard]] Vertex project(const glm::dvec3& world) const;
    void add_edge(const Vertex& p, const Vertex& q);
    void add_near_cut(const Vertex& a, const Vertex& b, const Vertex& c);
    [[nodiscard]] glm::dvec2 sample(int x, int y) const;

    const csg::solid::Geometry& geometry_;
    base::View view_;
    glm::dmat4 to_pixels_;  ///< Local (world minus the center of the scene's box) to homogeneous pixels.
    glm::dvec3 local_center_;
    std::vector<Edge> edges_;
    std::vector<base::View::PlaneDepth> planes_;
};

}  // namespace truth
