#include "npr/shaded.h"

#include "npr/style_pass.h"

namespace npr {
namespace {

class Shaded : public Style {
  public:
    explicit Shaded(const gl::Functions& gl) : pass_(gl, "npr/shaded.frag") {}
    [[nodiscard]] int layers_needed(const Parameters& /*parameters*/, bool translucent) const override {
        return translucent ? 0 : 1;
    }
    void draw(const Frame& frame) override { pass_.draw(frame); }

  private:
    StylePass pass_;
};

}  // namespace

StyleInfo shaded_style() {
    return {"shaded", "Shaded", [] { return std::span<const Parameter>(); },
            [](const gl::Functions& gl) -> std::unique_ptr<Style> { return std::make_unique<Shaded>(gl); }};
}

}  // namespace npr
