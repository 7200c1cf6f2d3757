// Visible edges drawn on beyond their ends.
#pragma once

#include "npr/edges/edge_map.h"

namespace npr {

/// Continues the straight visible edges of an edge map past their corners, fading, as a draftsman's lines cross
/// there.
class Overshoot {
  public:
    /// Throws gl::Error. `gl` must outlive the object.
    explicit Overshoot(const gl::Functions& gl);

    /// `edges` must have been drawn for the frame just before. `length` in pixels. Binds the continuations to texture
    /// units 5 and 6 for npr/edges/lines.glsl with OVERSHOOT defined.
    void draw(const Frame& frame, const EdgeMap& edges, float length);

  private:
    const gl::Functions& gl_;
    FrameProgram program_;
    gl::Texture
        points_;         ///< R32UI array of two: edge points (npr/edges/edge_point.glsl) on links to the right, and up.
    gl::Texture tiles_;  ///< R32UI: 1 where the tile has any.
};

}  // namespace npr
