// Sorted triangles that styles have colored.
#include <algorithm>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "npr/painter/cpu_tiles.h"
#include "npr/painter/whole_notes.h"
#include "npr/sorted/sorted_painter.h"
#include "npr/sorted/sorted_settings.h"
#include "npr/srgb.h"

namespace npr {
namespace {

/// What is drawn of a triangle in a pixel, and the lines that lie on it.
struct Drawn {
    std::uint32_t triangle = 0;
    std::uint32_t place = 0;  ///< When the triangle is drawn; 0: opaque.
    float depth = 0;          ///< Reversed.
    glm::vec4 color{0};       ///< sRGB with straight alpha.
    std::size_t first_line = 0, end_line = 0;
};

/// One pixel: notes of styles to triangles, and those to a color.
class PixelSort {
  public:
    PixelSort(const SortedSettings& settings, const SortedLayers& layers, const std::vector<std::uint32_t>& places)
        : blending_(settings.blending()), depth_writes_(settings.depth_writes), layers_(layers), places_(places) {}

    /// `ground`: color with its alpha in it. Gives the same of all that is drawn over it.
    glm::vec4 draw(std::vector<std::span<const Note>>& notes, std::size_t pixel, const glm::vec4& ground) {
        collect(notes, pixel);
        glm::vec4 color = ground;
        const auto solid = std::max_element(drawn_.begin(), drawn_.end(), [](const Drawn& a, const Drawn& b) {
            return opaque_depth(a) < opaque_depth(b);
        });
        float depth = solid == drawn_.end() ? 0 : opaque_depth(*solid);
        if (depth > 0) {
            color = blend({}, solid->color, color);
            draw_lines(solid->first_line, solid->end_line, color);
        }
        for (std::size_t i = loose_; i < lines_.size(); ++i) {
            color = lines_[i].depth > depth ? blend({}, lines_[i].color, color) : color;
        }
        std::sort(drawn_.begin(), drawn_.end(), [](const Drawn& a, const Drawn& b) { return a.place < b.place; });
        for (const Drawn& each : drawn_) {
            if (each.place > 0 && each.depth > depth) {
                color = blend(blending_, each.color, color);
                draw_lines(each.first_line, each.end_line, color);
                depth = depth_writes_ ? each.depth : depth;
            }
        }
        return color;
    }

  private:
    static float opaque_depth(const Drawn& drawn) { return drawn.place == 0 ? drawn.depth : 0; }

    /// Lines lie on the next surface; behind the last, on the ground.
    void collect(std::vector<std::span<const Note>>& notes, std::size_t pixel) {
        drawn_.clear();
        lines_.clear();
        loose_ = 0;
        while (const Note* note = PartNotes::take(notes)) {
            const std::uint32_t triangle = note->rank > 0 ? triangle_of(*note, pixel) : kNone;
            if (triangle == kNone) {
                lines_.push_back(*note);
                continue;
            }
            drawn_.push_back({triangle, places_[triangle], note->depth, note->color, loose_, lines_.size()});
            loose_ = lines_.size();
        }
    }

    /// That is not drawn yet; none where what was noted does not lie in the pixel.
    [[nodiscard]] std::uint32_t triangle_of(const Note& note, std::size_t pixel) const {
        const layers::SurfaceTable& table = *layers_.stack.table;
        for (std::size_t layer = 0; layer < static_cast<std::size_t>(layers_.stack.counts[pixel]); ++layer) {
            const layers::HostLayer& plane = layers_.stack.planes[layer];
            const layers::Surface s = layers::decode(plane.depth[pixel], plane.surface[pixel]);
            const std::uint32_t triangle = layers_.triangles[layer][pixel];
            if (s.depth == note.depth && table.parts[table.leaves[s.leaf].part.x].rank + 1 == note.rank &&
                std::none_of(drawn_.begin(), drawn_.end(), [&](const Drawn& d) { return d.triangle == triangle; })) {
                return triangle;
            }
        }
        return kNone;
    }

    /// The nearest is noted first.
    void draw_lines(std::size_t first, std::size_t end, glm::vec4& color) const {
        for (std::size_t i = end; i > first; --i) {
            color = blend({}, lines_[i - 1].color, color);
        }
    }

    static constexpr std::uint32_t kNone = ~0U;
    Blending blending_;
    bool depth_writes_;
    const SortedLayers& layers_;
    const std::vector<std::uint32_t>& places_;
    std::vector<Drawn> drawn_;
    std::vector<Note> lines_;
    std::size_t loose_ = 0;  ///< The first line that lies on no surface.
};

}  // namespace

const layers::HostStack& SortedPainter::layers(const base::View& view,
                                               const std::shared_ptr<const layers::SurfaceTable>& table) {
    draw_layers(mesh_, view, table, layers_);
    return layers_.stack;
}

std::vector<std::uint32_t> SortedPainter::places() const {
    std::vector<std::uint32_t> result(mesh_.triangles.size(), 0);
    for (std::uint32_t i = 0; i < clear_.size(); ++i) {
        result[clear_[by_distance_.order()[i]]] = i + 1;
    }
    return result;
}

void SortedPainter::paint_styled(const CpuFrame& frame, bool first) {
    const auto settings = transparency_settings<SortedSettings>(frame.picture);
    if (first || by_distance_.order().size() != clear_.size()) {
        sort(frame.picture, frame.view);
    }
    notes_.paint(frame);
    const std::vector<std::uint32_t> places = this->places();
    const std::vector<glm::vec4>& ground = notes_.ground();
    const SrgbTables& srgb = SrgbTables::get();
    const Tiles tiles(frame.layers);
    base::for_each_index(
        tiles.count(),
        [&] {
            return [&, sorter = PixelSort(settings, layers_, places),
                    notes = std::vector<std::span<const Note>>()](int tile) mutable {
                const TileBounds box = tiles.bounds(tile);
                std::size_t in_tile = 0;
                for (int y = box.lo.y; y < box.hi.y; ++y) {
                    for (int x = box.lo.x; x < box.hi.x; ++x, ++in_tile) {
                        const std::size_t pixel =
                            static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.layers.size.x) +
                            static_cast<std::size_t>(x);
                        notes_.read(tile, in_tile, notes);
                        const glm::vec4 c =
                            sorter.draw(notes, pixel, ground.empty() ? glm::vec4(0) : straight_srgb(ground[pixel]));
                        const float straight = 1 / std::max(c.a, 1e-6F);
                        frame.sum[pixel] +=
                            glm::vec4(srgb.linear(c.r * straight) * c.a, srgb.linear(c.g * straight) * c.a,
                                      srgb.linear(c.b * straight) * c.a, c.a);
                    }
                }
            };
        },
        0, frame.stop);
}

}  // namespace npr
