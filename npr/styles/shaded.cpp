// OpenSCAD's preview.
#include "npr/styles/pixel_style.h"

namespace npr {
namespace {

int layers(bool translucent) {
    return translucent ? layers::kAllLayers : 1;
}

using namespace glm;  // As shader files do.

struct ShadedPixels : PixelFrame {
    ShadedPixels(const CpuFrame& frame, const NoSettings& /*none*/) : PixelFrame(frame) {}
#include "npr/styles/shaded.glsl"

    void begin(int /*tile*/) {}
    glm::vec4 pixel(glm::ivec2 p) {
        return shaded(p);
    }
    [[nodiscard]] bool as_left(glm::ivec2 p) const {
        return !everywhere_new() && same_surfaces(p, {p.x - 1, p.y});
    }
};

}  // namespace

StyleInfo shaded_style() {
    return pixel_style<NoSettings, ShadedPixels>({"shaded", "Shaded", "npr/styles/shaded.frag", layers});
}

}  // namespace npr
