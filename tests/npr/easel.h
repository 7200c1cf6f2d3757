// A model whose pictures both painters draw.
#pragma once

#include <cstdlib>

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "goldfeather/smooth_facets.h"
#include "goldfeather/surface_table.h"
#include "npr/painter/cpu_accumulate.h"
#include "tests/npr/scene.h"

namespace scene {

/// A model with its lists, drawn either way.
class Easel {
  public:
    /// Are the faces that the last leaf leaves those of a section?
    enum class LastLeaf { IsAsOthers, IsSection };

    explicit Easel(const Model& model, LastLeaf last = LastLeaf::IsAsOthers)
        : subject_(random_tree::make_tree(model)), lists_(subject_.scene, subject_.geometry) {
        for (std::size_t i = 0; last == LastLeaf::IsSection && i < subject_.scene.leaves.size(); ++i) {
            const auto& leaves = subject_.geometry.leaves;  // Each part has its own copy of what cuts it.
            subject_.scene.leaves[i].hatching = leaves[i].box == leaves.back().box ? 1 : 0;
        }
        const auto table = goldfeather::surface_table(subject_.scene, subject_.geometry);
        table->smooth = goldfeather::smooth_facets(subject_.geometry);
        layers_.table = table;
    }

    [[nodiscard]] const csg::Box& box() const { return subject_.geometry.box; }

    /// `layers`: the first so many; 0: all.
    [[nodiscard]] base::Image paint(const npr::Picture& picture, unsigned threads = 0, int layers = 0) {
        most_layers_ = layers;
        base::Image image = paint(picture.style->make_paint(), picture, threads);
        most_layers_ = 0;
        return image;
    }

    [[nodiscard]] base::Image paint(const npr::Paint& paint, const npr::Picture& picture, unsigned threads = 0) {
        npr::CpuAccumulator accumulator;
        accumulate(accumulator, paint, picture, threads);
        return accumulator.image();
    }

    /// By pixel, rows from bottom to top: linear light.
    [[nodiscard]] std::vector<glm::vec4> light(const npr::Picture& picture) {
        npr::CpuAccumulator accumulator;
        accumulate(accumulator, picture.style->make_paint(), picture, 0);
        return accumulator.light();
    }
    [[nodiscard]] std::vector<glm::vec4> light(const gl::Functions& gl, const npr::Picture& picture) {
        npr::Accumulator accumulator(gl);
        accumulate(gl, accumulator, picture);
        return accumulator.light();
    }

    [[nodiscard]] base::Image draw(const gl::Functions& gl, const npr::Picture& picture) {
        npr::Accumulator accumulator(gl);
        accumulate(gl, accumulator, picture);
        return accumulator.image();
    }
    /// By a style that has been made before, and an accumulator: making them takes far longer than a small picture.
    [[nodiscard]] base::Image draw(const gl::Functions& gl, npr::Accumulator& accumulator, npr::Style& style,
                                   const npr::Picture& picture) {
        accumulate(gl, accumulator, style, picture);
        return accumulator.image();
    }

    /// Blocks of pixels lie in shadows, in each layer others: for what styles make of them, wherever they are from.
    void darken_blocks() {
        shadows_ = [](const base::View& v) {
            std::vector<npr::ShadowBits> bits;
            for (int y = 0; y < v.size().y; ++y) {
                for (int x = 0; x < v.size().x; ++x) {
                    bits.push_back(0xc35aU >> ((x / 7 + y / 9) % 8));
                }
            }
            return bits;
        };
    }

  private:
    void accumulate(npr::CpuAccumulator& accumulator, const npr::Paint& paint, const npr::Picture& picture,
                    unsigned threads) {
        const npr::CpuSubject subject{box().lo, box().hi,
                                      [&](const base::View& v) -> const layers::HostStack& {
                                          goldfeather::ListsStats stats;
                                          goldfeather::peel_lists(lists_, v, most_layers_, threads, layers_, stats);
                                          return layers_;
                                      },
                                      nullptr, shadows_};
        for (std::size_t i = 0; i < npr::sample_offsets(picture.samples).size(); ++i) {
            accumulator.paint_sample(paint, picture, i, subject);
        }
    }

    void accumulate(const gl::Functions& gl, npr::Accumulator& accumulator, const npr::Picture& picture) {
        accumulate(gl, accumulator, *picture.style->make(gl), picture);
    }

    void accumulate(const gl::Functions& gl, npr::Accumulator& accumulator, npr::Style& style,
                    const npr::Picture& picture) {
        const auto engine = goldfeather::make_engine(*goldfeather::find_engine("lists-cpu"), {&gl});
        const auto prepared = engine->prepare(subject_.input());
        accumulator.draw(style, picture,
                         {box().lo, box().hi, [&](const base::View& v) { return peel(gl, subject_, *prepared, v); },
                          nullptr, shadows_});
    }

    comparison::Subject subject_;
    goldfeather::ListsModel lists_;
    layers::HostStack layers_;
    npr::FindShadows shadows_;
    int most_layers_ = 0;
};

/// Pixels that differ by more than `channel` in some channel.
inline int differing(const base::Image& a, const base::Image& b, int channel) {
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        bool far = false;
        for (std::size_t c = i; c < i + 4; ++c) {
            far = far || std::abs(a.rgba[c] - b.rgba[c]) > channel;
        }
        count += far ? 1 : 0;
    }
    return count;
}

}  // namespace scene
