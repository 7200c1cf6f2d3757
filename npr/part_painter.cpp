#include "npr/part_painter.h"

#include <algorithm>

#include "npr/painter/cpu_paint.h"

namespace npr {
namespace {

/// Puts notes, media and ground together, pixel by pixel.
struct Together : PixelFrame {
    explicit Together(const CpuFrame& frame)
        : PixelFrame(frame),
          highlights_(static_cast<std::uint32_t>(
              std::count_if(frame.layers.table->parts.begin(), frame.layers.table->parts.end(),
                            [](const layers::PartLook& part) { return part.kind == layers::PartKind::Highlight; }))) {}

    glm::vec4 put(std::vector<std::span<const Note>>& notes, glm::ivec2 pixel, const glm::vec4* ground) {
        Composite seen = nothing_seen();
        Media media = media_at_eye(pixel);
        const glm::vec3 ray = pixel_ray(pixel);
        int layer = 0;
        Note surface;
        while (seen.through > least_seen()) {
            const Note* note = PartNotes::take(notes);
            if (transparency == kVolume) {
                pass_media(seen, media, layer, pixel, ray, note != nullptr ? note->depth : 0);
            }
            if (note == nullptr) {
                break;
            }
            if (!seen_once(*note, surface)) {
                continue;
            }
            surface = note->rank > 0 ? *note : surface;
            seen = Frame::behind(seen, true, note->color);
        }
        const bool bare = ground != nullptr && seen.through > 0;
        return before_ground(seen.color, seen.through, bare ? srgb_of(*ground) : glm::vec3(0));
    }

  private:
    /// The media up to that depth: those that the layers of all parts bound.
    void pass_media(Composite& seen, Media& media, int& layer, glm::ivec2 pixel, glm::vec3 ray, float depth) {
        for (; layer_depth(pixel, layer) > 0 && layer_depth(pixel, layer) >= depth; ++layer) {
            const Surface s = layer_surface(pixel, layer, ray);
            seen = reached(seen, media, s, ray);
            media = beyond(media, s);
        }
        if (depth > 0 && media.at < view_distance(depth)) {
            Surface there = no_surface();
            there.hit = true;
            there.depth = depth;
            seen = reached(seen, media, there, ray);
            media.at = view_distance(depth);
        }
    }
    /// Of the faces that parts have in one place one is seen (npr/transparency.glsl); highlights are in any case.
    [[nodiscard]] bool seen_once(const Note& note, const Note& surface) const {
        return note.rank <= highlights_ || surface.rank <= highlights_ || note.depth != surface.depth ||
               note.rank == surface.rank;
    }
    /// Much of the ground has one color.
    glm::vec3 srgb_of(const glm::vec4& ground) {
        if (ground != last_ground_) {
            last_ground_ = ground;
            last_srgb_ = glm::vec3(straight_srgb(ground));
        }
        return last_srgb_;
    }

    std::uint32_t highlights_;  ///< Ranks of parts that are none are at least this.
    glm::vec4 last_ground_{0};
    glm::vec3 last_srgb_{0};
};

}  // namespace

void PartPainter::operator()(const CpuFrame& frame) {
    notes_.paint(frame);
    const std::vector<glm::vec4>& ground = notes_.ground();
    const Tiles tiles(frame.layers);
    base::for_each_index(
        tiles.count(),
        [&] {
            return [&, together = Together(frame), notes = std::vector<std::span<const Note>>()](int tile) mutable {
                const TileBounds box = tiles.bounds(tile);
                std::size_t in_tile = 0;
                for (int y = box.lo.y; y < box.hi.y; ++y) {
                    for (int x = box.lo.x; x < box.hi.x; ++x, ++in_tile) {
                        notes_.read(tile, in_tile, notes);
                        const std::size_t pixel = together.index({x, y});
                        frame.sum[pixel] += together.put(notes, {x, y}, ground.empty() ? nullptr : &ground[pixel]);
                    }
                }
            };
        },
        0, frame.stop);
}

}  // namespace npr
