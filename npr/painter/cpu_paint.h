// Pixels from shared shader files to a frame, tile by tile.
#pragma once

#include "base/parallel.h"
#include "npr/painter/cpu_ink.h"
#include "npr/painter/pixel_frame.h"
#include "npr/painter/whole_notes.h"

namespace npr {

/// A Frame with the ink of lines: what npr/edges/lines.glsl is to shaders.
struct LinedFrame : PixelFrame {
    LinedFrame(const CpuFrame& frame, const CpuEdges& edges, const LinedSettings& lines)
        : PixelFrame(frame), ink(frame, edges, lines) {
        reach = static_cast<int>(0.5F * lines.width + 0.5F) + 1;
    }

    TileInk ink;
    glm::ivec2 at{0};  ///< The pixel to be painted.

    void begin(int tile) { ink.draw(tile, *this); }
    [[nodiscard]] bool as_left(glm::ivec2 p) const {
        const glm::ivec2 left(p.x - 1, p.y);
        return !everywhere_new() && !ink.near(p) && !ink.near(left) && same_surfaces(p, left);
    }

    [[nodiscard]] bool line_near(int layer) const { return layer < kLayersApart && ink.near(at); }
    [[nodiscard]] float line_ink(int layer) const { return ink.ink(layer, at); }
};

/// Notes what a painter draws in a tile.
template <typename Painter>
void note_tile(const CpuFrame& frame, const TileBounds& box, Painter& painter, TileNotes& page) {
    const WholeNotes whole(frame);
    for (int y = box.lo.y; y < box.hi.y; ++y) {
        bool empty = false;
        for (int x = box.lo.x; x < box.hi.x; ++x) {
            if (empty && painter.as_left({x, y})) {
                page.end_pixel();
                continue;
            }
            if constexpr (std::is_base_of_v<PixelFrame, Painter>) {
                painter.page = &page;
                painter.noted = {x, y};
            }
            const glm::vec4 color = painter.pixel({x, y});
            if (color.a > 0 && page.pixel_is_empty()) {
                page.add(whole.note({x, y}, color));
            }
            empty = page.pixel_is_empty();
            page.end_pixel();
        }
    }
}

/// Adds every pixel of the frame, or notes what is drawn there, or throws base::Stopped. `make()` gives each thread its
/// painter:
///   begin(tile)         before the tile's pixels
///   pixel(p)            the color
///   as_left(p)          whether it is sure to be that of the pixel on the left, of the same tile
template <typename Make>
void paint_tiles(const CpuFrame& frame, const Make& make) {
    const Tiles tiles(frame.layers);
    base::for_each_index(
        tiles.count(),
        [&] {
            return [&tiles, &frame, painter = make()](int tile) mutable {
                const TileBounds box = tiles.bounds(tile);
                painter.begin(tile);
                if (frame.notes != nullptr) {
                    note_tile(frame, box, painter, (*frame.notes)[static_cast<std::size_t>(tile)]);
                    return;
                }
                for (int y = box.lo.y; y < box.hi.y; ++y) {
                    glm::vec4* row =
                        &frame.sum[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.layers.size.x)];
                    glm::vec4 color(0);
                    for (int x = box.lo.x; x < box.hi.x; ++x) {
                        if (x == box.lo.x || !painter.as_left({x, y})) {
                            color = painter.pixel({x, y});
                        }
                        row[x] += color;
                    }
                }
            };
        },
        0, frame.stop);
}

}  // namespace npr
