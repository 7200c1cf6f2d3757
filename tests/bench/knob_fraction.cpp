// The knob of peeling: the fraction of pixels below which it ends. Whole frames, since it saves work of styles too.
#include <algorithm>
#include <cstdlib>
#include <optional>

#include "tests/bench/knobs.h"
#include "ui/pipeline/picture/renderer.h"

namespace bench {

namespace {

/// Pixels of which a channel differs by more than rounding, in percent.
double difference_percent(const base::Image& a, const base::Image& b) {
    constexpr int kRounding = 2;
    const std::size_t pixels = a.rgba.size() / 4;
    std::size_t different = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        bool differs = false;
        for (std::size_t channel = 4 * i; channel < 4 * i + 4; ++channel) {
            differs = differs || std::abs(int{a.rgba[channel]} - int{b.rgba[channel]}) > kRounding;
        }
        different += differs ? 1 : 0;
    }
    return 100 * static_cast<double>(different) / static_cast<double>(std::max<std::size_t>(1, pixels));
}

}  // namespace

void turn_minimal_fraction(gl::Context& context, const Subject& subject, const KnobOptions& options,
                           std::vector<KnobRow>& rows) {
    ui::PictureRequest request;
    request.camera = subject.camera;
    request.size = glm::ivec2(options.side);
    request.draw_as(*npr::find_style("blueprint"));
    request.layers = goldfeather::kAllLayers;
    request.samples = 1;
    for (const goldfeather::EngineInfo* kind :
         {goldfeather::find_engine("lists-cpu"), goldfeather::find_engine("goldfeather")}) {
        std::optional<base::Image> whole;
        for (const double fraction : {0.0, 1e-4, 1e-3, 1e-2, 1e-1}) {
            context.make_current();
            goldfeather::EngineOptions engine(kind);
            engine.minimal_fraction = fraction;
            ui::Renderer renderer(context, engine);
            base::Image image;
            const Time time = median(options.repeat, [&] { image = renderer.render(*subject.model, request); });
            if (!whole) {
                whole = image;
            }
            rows.push_back({"minimal fraction", subject.name, std::string(kind->name), fraction, time.cpu,
                            difference_percent(*whole, image)});
        }
    }
}

}  // namespace bench
