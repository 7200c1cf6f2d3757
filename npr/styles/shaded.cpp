// OpenSCAD's preview.
#include <bit>

#include "npr/painter/memo.h"
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
        return transparency == kExact && section_spacing <= 0.0F ? shaded_by_planes(p) : shaded(p);
    }
    [[nodiscard]] bool as_left(glm::ivec2 p) const {
        return !everywhere_new() && same_surfaces(p, {p.x - 1, p.y});
    }

  private:
    /// The same as shaded(): light is flat, so that a surface's color is that of its plane, leaf and side, which are
    /// remembered; but for faces that several parts have. Without hatching.
    glm::vec4 shaded_by_planes(glm::ivec2 p) {
        Composite seen = nothing_seen();
        while (goes_on(seen, layer_count, 0.0F)) {
            const int layer = seen.layer;
            const uvec2 ids = surface_ids(p, layer);
            const bool hit = ids.x != kNoSurface;
            vec4 c(0);
            if (hit) {
                c = colors_.of(std::bit_cast<std::uint64_t>(ids), [&] {
                    Surface s = layer_surface(p, layer, pixel_ray(p));
                    s.covered = is_medium(s.part);
                    return surface_color(s);
                });
                if (c.a > 0 && c.a < 1 && shares_depth(p, layer)) {
                    c = surface_color(seen_surface(p, layer, pixel_ray(p)));
                }
            }
            seen = behind(seen, hit, c);
        }
        return before_background(seen.color, seen.through, p);
    }
    [[nodiscard]] bool shares_depth(glm::ivec2 p, int layer) const {
        const float depth = layer_depth(p, layer);
        return (layer > 0 && layer_depth(p, layer - 1) == depth) || layer_depth(p, layer + 1) == depth;
    }

    Memo<vec4, 10> colors_;  ///< By the words of a surface: sRGB, straight alpha.
};

}  // namespace

StyleInfo shaded_style() {
    return pixel_style<NoSettings, ShadedPixels>({"shaded", "Shaded", "npr/styles/shaded.frag", layers});
}

}  // namespace npr
