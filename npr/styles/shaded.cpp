#include "npr/styles/shaded.h"

#include "npr/painter/cpu_paint.h"
#include "npr/style_pass.h"

namespace npr {
namespace {

int layers(bool translucent) {
    return translucent ? 0 : 1;
}

class Shaded : public Style {
  public:
    explicit Shaded(const gl::Functions& gl) : pass_(gl, "npr/styles/shaded.frag") {}
    void draw(const Frame& frame) override { pass_.draw(frame); }

  private:
    StylePass pass_;
};

using namespace glm;  // As shader files do.

struct ShadedPixels : shader::Frame {
    using Frame::Frame;
#include "npr/styles/shaded.glsl"

    void begin(int /*tile*/) {}
    glm::vec4 pixel(glm::ivec2 p) {
        return shaded(p);
    }
    [[nodiscard]] bool as_left(glm::ivec2 p) const {
        return same_surfaces(p, {p.x - 1, p.y});
    }
};

void paint(const CpuFrame& frame) {
    paint_tiles(frame, [&] { return ShadedPixels(frame); });
}

}  // namespace

StyleInfo shaded_style() {
    return {"shaded",
            "Shaded",
            [] { return std::span<const Parameter>(); },
            [](const gl::Functions& gl) -> std::unique_ptr<Style> { return std::make_unique<Shaded>(gl); },
            [] { return Paint(paint); },
            layers};
}

}  // namespace npr
