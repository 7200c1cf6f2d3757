// OpenCSG (libopencsg) beside our engines: the same products, the same meshes, in an OpenGL context of its own.
// For comparison only; nothing of it is part of the program.
//
// What is inside, OpenCSG finds by parity: it peels as many layers of a leaf as the leaf's convexity says, and counts
// surfaces in front of each, whichever way they face (its SCS takes front for entering and back for leaving, once). Of
// leaves whose shells overlap it shows the even-odd solid.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/camera.h"
#include "csg/solid/placed.h"
#include "goldfeather/products.h"

namespace opencsg {

enum class Algorithm { Automatic, Goldfeather, Scs };

/// Distances of the first surface from the eye's plane, along the axis of view; rows from bottom to top. Infinite where
/// there is none.
struct Picture {
    glm::ivec2 size{0};
    std::vector<double> distance;
};

class OpenCsg {
  public:
    virtual ~OpenCsg() = default;
    /// Loads the leaves as display lists, positions taken from the middle of the scene. Both must outlive the drawing.
    /// A leaf that is not convex is given the convexity 8.
    virtual void load(const csg::solid::Geometry& geometry, const std::vector<std::vector<goldfeather::Product>>& parts,
                      const base::View& view, Algorithm algorithm) = 0;
    /// Draws a frame: OpenCSG's depth of every product, then the leaves shaded where they have that depth; waits.
    virtual void draw() = 0;
    /// The frame drawn last.
    [[nodiscard]] virtual Picture read() = 0;
};

/// False where the library was missing when this was built.
[[nodiscard]] bool built();

/// Null and a reason where there is no library or no OpenGL for it. Its context is made current by every call of the
/// object.
struct MaybeOpenCsg {
    std::unique_ptr<OpenCsg> engine;
    std::string reason;
};
[[nodiscard]] MaybeOpenCsg create(glm::ivec2 largest_size);

}  // namespace opencsg
