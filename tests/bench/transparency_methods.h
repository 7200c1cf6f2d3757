// What people would otherwise take, for the table of tests/bench/transparency_main.cpp only: small implementations on
// the triangles of the mesh.
#pragma once

#include <vector>

#include "base/camera.h"
#include "base/image.h"
#include "npr/picture.h"
#include "npr/sorted/sorted_painter.h"

namespace bench {

/// Triangles before the eye, with their lit colors; made once for a view.
struct ShadedTriangles {
    struct Triangle {
        std::array<glm::dvec3, 3> eye, at;
        glm::vec4 color;
    };
    std::vector<Triangle> opaque, clear;  ///< Clear ones face the eye.
};

[[nodiscard]] ShadedTriangles shade(const npr::ColoredMesh& mesh, const base::View& view);

/// McGuire and Bavoil 2013, with their weight (10): all surfaces in one pass, in any order. 36 bytes a pixel.
[[nodiscard]] base::Image weighted_blended(const ShadedTriangles& triangles, const npr::Picture& picture,
                                           const base::View& view);

/// Enderton and others 2010: each of `samples` depth buffers keeps a surface by chance. 20 bytes a pixel and sample.
[[nodiscard]] base::Image stochastic(const ShadedTriangles& triangles, const npr::Picture& picture,
                                     const base::View& view, int samples);

}  // namespace bench
