#include "npr/styles/cpu_sketch_noise.h"

#include <array>

#include "base/parallel.h"
#include "npr/shader_frame.h"

namespace npr {
namespace {

using namespace glm;  // As shader files do.

struct NoisePixels : shader::Frame, SketchSettings {
    NoisePixels(const CpuFrame& frame, const SketchSettings& settings, const Relief& relief)
        : Frame(frame), SketchSettings(settings), relief_cell(relief.cell), relief_(relief) {}

    float relief_cell;
    [[nodiscard]] ivec2 relief_size() const { return relief_.size; }
    [[nodiscard]] float relief_distance(ivec2 cell) const {
        return relief_.distances[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(relief_.size.x) +
                                 static_cast<std::size_t>(cell.x)];
    }

#include "npr/styles/noise.glsl"

    /// Cells are many pixels wide: the gradients of the one met last in each lattice are kept.
    float perlin_noise(vec3 p, uint s) {
        Lattice& lattice = lattices[s % 8U];
        const vec3 f = p - lattice.low;
        if (lattice.known && all(greaterThanEqual(f, vec3(0))) && all(lessThan(f, vec3(1)))) {
            return noise_between(lattice.gradients, f);
        }
        lattice.low = floor(p);
        lattice.gradients = gradients_about(ivec3(lattice.low), s);
        lattice.known = true;
        return noise_between(lattice.gradients, p - lattice.low);
    }

#include "npr/styles/sketch_noise.glsl"

  private:
    struct Lattice {
        bool known = false;
        vec3 low{0};  ///< Corner of the cell.
        Gradients gradients;
    };
    const Relief& relief_;
    std::array<Lattice, 8> lattices{};  ///< By what npr/styles/sketch_noise.glsl adds to eight times the seed.
};

}  // namespace

void CpuSketchNoise::draw(const CpuFrame& frame, const SketchSettings& settings) {
    const ivec2 size = frame.layers.size;
    const NoiseKey key = noise_key(settings, size, frame.picture.guard);
    if (key_ == key && (frame.sample > 0 || !settings.on_model)) {
        return;
    }
    key_.reset();
    const layers::SurfaceTable& table = *frame.layers.table;
    const Relief relief = settings.on_model ? sketch_relief(frame.view, frame.layers.planes.front().depth, settings,
                                                            table.local_center, table.diagonal)
                                            : Relief();
    const auto width = static_cast<std::size_t>(size.x), pixels = width * static_cast<std::size_t>(size.y);
    strokes_.resize(pixels);
    grain_.resize(pixels);
    base::for_each_index(
        size.y,
        [&] {
            return [&, rules = NoisePixels(frame, settings, relief)](int y) mutable {
                const std::size_t row = static_cast<std::size_t>(y) * width;
                for (int x = 0; x < size.x; ++x) {
                    strokes_[row + static_cast<std::size_t>(x)] = rules.sketch_noise({x, y});
                    grain_[row + static_cast<std::size_t>(x)] =
                        rules.paper_grain({x - rules.guard, y - rules.guard}, settings.seed);
                }
            };
        },
        0, frame.stop);
    key_ = key;
}

}  // namespace npr
