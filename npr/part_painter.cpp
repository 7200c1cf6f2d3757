#include "npr/part_painter.h"

#include <algorithm>

#include "npr/layer_filter.h"
#include "npr/painter/cpu_paint.h"
#include "npr/part_style.h"
#include "npr/style.h"

namespace npr {
namespace {

/// Puts notes and ground together, pixel by pixel.
struct Together : PixelFrame {
    using PixelFrame::PixelFrame;

    glm::vec4 put(std::span<std::span<const Note>> notes, const glm::vec4* ground) {
        Composite seen = nothing_seen();
        while (seen.through > 0) {
            std::span<const Note>* nearest = nullptr;
            for (std::span<const Note>& each : notes) {
                if (!each.empty() && (nearest == nullptr || before(each.front(), nearest->front()))) {
                    nearest = &each;
                }
            }
            if (nearest == nullptr) {
                break;
            }
            seen = Frame::behind(seen, true, nearest->front().color);
            *nearest = nearest->subspan(1);
        }
        const bool bare = ground != nullptr && seen.through > 0;
        return before_ground(seen.color, seen.through, bare ? srgb_of(*ground) : glm::vec3(0));
    }

  private:
    /// Much of the ground has one color.
    glm::vec3 srgb_of(const glm::vec4& ground) {
        if (ground != last_ground_) {
            last_ground_ = ground;
            last_srgb_ = glm::vec3(straight_srgb(ground));
        }
        return last_srgb_;
    }
    static bool before(const Note& a, const Note& b) {
        return a.depth > b.depth || (a.depth == b.depth && a.part < b.part);
    }

    glm::vec4 last_ground_{0};
    glm::vec3 last_srgb_{0};
};

}  // namespace

void PartPainter::operator()(const CpuFrame& frame) {
    const std::vector<std::size_t> group_of_part = styles_of_parts(frame.picture, frame.layers.table->parts);
    drawn_.clear();
    for (std::size_t group = 0; group <= frame.picture.part_styles.size(); ++group) {
        if (std::find(group_of_part.begin(), group_of_part.end(), group) != group_of_part.end()) {
            paint_group(frame, group, group_of_part);
        }
    }
    if (!frame.picture.transparent_background) {
        paint_ground(frame);
    }
    put_together(frame);
}

void PartPainter::paint_group(const CpuFrame& frame, std::size_t group, std::span<const std::size_t> group_of_part) {
    Picture picture = frame.picture;
    picture.part_styles.clear();
    picture.transparent_background = true;
    if (group > 0) {
        picture.style = frame.picture.part_styles[group - 1].style;
        picture.parameters = frame.picture.part_styles[group - 1].parameters;
    }
    Group& mine = groups_[{group, picture.style}];
    if (!mine.paint) {
        mine.paint = picture.style->make_paint();
    }
    filter_layers(
        frame.layers,
        [&] {
            return [&](const layers::Surface& s) {
                return group_of_part[frame.layers.table->leaves[s.leaf].part.x] == group;
            };
        },
        mine.stack, frame.stop);
    mine.notes.resize(static_cast<std::size_t>(Tiles(mine.stack).count()));
    for (TileNotes& tile : mine.notes) {
        tile.clear();
    }
    mine.paint({picture, frame.view, mine.stack, {}, frame.stop, {}, &mine.notes});
    drawn_.push_back(&mine);
}

void PartPainter::paint_ground(const CpuFrame& frame) {
    Picture picture = frame.picture;
    picture.part_styles.clear();
    empty_.resize(frame.layers.size);
    empty_.reserve(1);
    empty_.layers = 1;
    empty_.complete = true;
    empty_.table = frame.layers.table;
    ground_.assign(frame.sum.size(), glm::vec4(0));
    Group& mine = groups_[{0, picture.style}];
    if (!mine.paint) {
        mine.paint = picture.style->make_paint();
    }
    mine.paint({picture, frame.view, empty_, ground_, frame.stop});
}

void PartPainter::put_together(const CpuFrame& frame) {
    const Tiles tiles(frame.layers);
    base::for_each_index(
        tiles.count(),
        [&] {
            return [&, together = Together(frame),
                    notes = std::vector<std::span<const Note>>(drawn_.size())](int tile) mutable {
                const TileBounds box = tiles.bounds(tile);
                std::size_t in_tile = 0;
                for (int y = box.lo.y; y < box.hi.y; ++y) {
                    for (int x = box.lo.x; x < box.hi.x; ++x, ++in_tile) {
                        for (std::size_t i = 0; i < drawn_.size(); ++i) {
                            notes[i] = drawn_[i]->notes[static_cast<std::size_t>(tile)].of(in_tile);
                        }
                        const std::size_t pixel = together.index({x, y});
                        frame.sum[pixel] +=
                            together.put(notes, frame.picture.transparent_background ? nullptr : &ground_[pixel]);
                    }
                }
            };
        },
        0, frame.stop);
}

}  // namespace npr
