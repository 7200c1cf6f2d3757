#include "npr/part_notes.h"

#include <algorithm>

#include "npr/layer_filter.h"
#include "npr/part_style.h"
#include "npr/style.h"

namespace npr {
namespace {

/// Among the groups: what a style keeps of one is of no use for another.
constexpr std::size_t kGround = ~std::size_t{0};
constexpr int kNoLayer = 1 << 30;  ///< As kNothingHides (npr/shine/shine_rules.glsl).

/// What a pixel of a view-dependent picture shows, with the layers counted that are left of it.
ShineRow in_group(const ShineRow& row, const layers::HostStack& all, std::size_t pixel,
                  std::span<const std::size_t> group_of_part, std::size_t group) {
    ShineRow mine = row;
    mine.front = -1;
    mine.last = mine.hidden = kNoLayer;
    int kept = 0;
    for (int layer = 0; layer < all.layers; ++layer) {
        const glm::uvec2 ids = all.planes[static_cast<std::size_t>(layer)].surface[pixel];
        if (ids.x == layers::kNoSurface) {
            break;
        }
        if (layer >= row.hidden) {
            mine.hidden = std::min(mine.hidden, kept);
        }
        const layers::Surface s = layers::decode(1, ids);
        if (group_of_part[all.table->leaves[s.leaf].part.x] == group) {
            mine.front = layer == row.front ? kept : mine.front;
            mine.last = layer == row.last ? kept : mine.last;
            ++kept;
        }
    }
    return mine;
}

/// The bits of the layers that are left of a pixel.
ShadowBits bits_in_group(ShadowBits bits, const layers::HostStack& all, std::size_t pixel,
                         std::span<const std::size_t> group_of_part, std::size_t group) {
    ShadowBits mine = 0;
    int kept = 0;
    for (int layer = 0; layer < std::min(all.layers, kLayersInShadow) && bits >> layer != 0; ++layer) {
        const glm::uvec2 ids = all.planes[static_cast<std::size_t>(layer)].surface[pixel];
        if (group_of_part[all.table->leaves[layers::decode(1, ids).leaf].part.x] == group) {
            mine |= (bits >> layer & 1U) << kept;
            ++kept;
        }
    }
    return mine;
}

}  // namespace

void PartNotes::paint(const CpuFrame& frame) {
    const std::vector<std::size_t> group_of_part = styles_of_parts(frame.picture, frame.layers.table->parts);
    drawn_.clear();
    for (std::size_t number = 0; number <= frame.picture.part_styles.size(); ++number) {
        if (std::find(group_of_part.begin(), group_of_part.end(), number) != group_of_part.end()) {
            paint_group(frame, number, group_of_part);
        }
    }
    ground_.clear();
    if (!frame.picture.transparent_background) {
        paint_ground(frame);
    }
}

PartNotes::Group& PartNotes::group(std::size_t number, const Picture& picture) {
    Group& result = groups_[{number, picture.style}];
    if (!result.paint) {
        result.paint = picture.style->make_paint();
    }
    return result;
}

void PartNotes::paint_group(const CpuFrame& frame, std::size_t number, std::span<const std::size_t> group_of_part) {
    Picture picture = frame.picture;
    picture.part_styles.clear();
    picture.transparent_background = true;
    if (number > 0) {
        picture.style = frame.picture.part_styles[number - 1].style;
        picture.parameters = frame.picture.part_styles[number - 1].parameters;
    }
    Group& mine = group(number, picture);
    filter_layers(
        frame.layers,
        [&] {
            return [&](const layers::Surface& s) {
                return group_of_part[frame.layers.table->leaves[s.leaf].part.x] == number;
            };
        },
        mine.stack, frame.stop);
    mine.shine.clear();
    for (std::size_t pixel = 0; pixel < frame.shine.size(); ++pixel) {
        mine.shine.push_back(in_group(frame.shine[pixel], frame.layers, pixel, group_of_part, number));
    }
    mine.shadows.clear();
    for (std::size_t pixel = 0; pixel < frame.shadows.size(); ++pixel) {
        mine.shadows.push_back(bits_in_group(frame.shadows[pixel], frame.layers, pixel, group_of_part, number));
    }
    mine.notes.resize(static_cast<std::size_t>(Tiles(mine.stack).count()));
    for (TileNotes& tile : mine.notes) {
        tile.clear();
    }
    CpuFrame own{picture, frame.view, mine.stack, {}, frame.stop};
    own.sample = frame.sample;
    own.shine = mine.shine;
    own.shadows = mine.shadows;
    own.notes = &mine.notes;
    mine.paint(own);
    if (const float opacity = number > 0 ? frame.picture.part_styles[number - 1].opacity : 1; opacity < 1) {
        for (TileNotes& tile : mine.notes) {
            tile.fade(opacity);
        }
    }
    drawn_.push_back(&mine);
}

void PartNotes::paint_ground(const CpuFrame& frame) {
    Picture picture = frame.picture;
    picture.part_styles.clear();
    empty_.resize(frame.layers.size);
    empty_.reserve(1);
    empty_.layers = 1;
    empty_.complete = true;
    empty_.table = frame.layers.table;
    ground_.assign(frame.sum.size(), glm::vec4(0));
    CpuFrame bare{picture, frame.view, empty_, ground_, frame.stop};
    bare.sample = frame.sample;
    group(kGround, picture).paint(bare);
}

void PartNotes::read(int tile, std::size_t in_tile, std::vector<std::span<const Note>>& notes) const {
    notes.clear();
    for (const Group* each : drawn_) {
        notes.push_back(each->notes[static_cast<std::size_t>(tile)].of(in_tile));
    }
}

const Note* PartNotes::take(std::vector<std::span<const Note>>& notes) {
    const auto before = [](const Note& a, const Note& b) {
        return a.depth > b.depth || (a.depth == b.depth && a.rank < b.rank);
    };
    std::span<const Note>* nearest = nullptr;
    for (std::span<const Note>& each : notes) {
        if (!each.empty() && (nearest == nullptr || before(each.front(), nearest->front()))) {
            nearest = &each;
        }
    }
    if (nearest == nullptr) {
        return nullptr;
    }
    const Note* result = &nearest->front();
    *nearest = nearest->subspan(1);
    return result;
}

}  // namespace npr
