// A frame whose painter can note what it draws, layer by layer.
#pragma once

#include <utility>
#include <vector>

#include "npr/painter/layer_notes.h"
#include "npr/shader_frame.h"

namespace npr {

/// A Frame for styles that walk the layers (peel/composite.glsl). Where `page` is set, the colors that they put behind
/// each other are noted, and lines apart from the surfaces on which they are drawn.
struct PixelFrame : shader::Frame {
    using Frame::Frame;

    TileNotes* page = nullptr;  ///< Of the tile that is painted.
    glm::ivec2 noted{0};        ///< The pixel that is painted.
    int reach = 0;              ///< How far lines lie from what they bound, in pixels.

    glm::vec4 with_line(glm::vec4 c, glm::vec3 line_color, float ink) {
        if (page == nullptr) {
            return Frame::with_line(c, line_color, ink);
        }
        if (ink > 0) {
            lines_.emplace_back(line_color, ink);
        }
        return c;
    }
    Composite behind(const Composite& c, bool hit, glm::vec4 color) {
        if (page != nullptr) {
            note(c.layer, hit, color);
        }
        return Frame::behind(c, hit, color);
    }
    /// Media are for whoever puts notes together: they are those of all parts.
    Composite reached(const Composite& c, const Media& m, const Surface& s, glm::vec3 ray) {
        return page != nullptr ? c : Frame::reached(c, m, s, ray);
    }

  private:
    /// The last line drawn is the nearest.
    void note(int layer, bool hit, glm::vec4 color);
    /// Lines of a layer lie where the nearest surface of that layer is within their reach, and a little before it: what
    /// they bound may stand on, or before, what is beside it.
    [[nodiscard]] float line_depth(int layer) const;

    std::vector<glm::vec4> lines_;  ///< Of the layer, not yet noted.
};

}  // namespace npr
