#include "npr/reveal.h"

#include <algorithm>
#include <limits>

#include "npr/layer_filter.h"
#include "npr/medium_rows.h"

namespace npr {
namespace {

/// By part: whether one of them reveals it.
std::vector<char> revealed_parts(std::span<const RevealedPart> wishes, std::span<const layers::PartLook> parts) {
    std::vector<char> result;
    for (const layers::PartLook& part : parts) {
        result.push_back(
            std::any_of(wishes.begin(), wishes.end(), [&](const RevealedPart& wish) { return selects(wish.of, part); })
                ? 1
                : 0);
    }
    return result;
}

/// By part: whether only what is within it is seen, in `volume`.
std::vector<char> media_parts(const Picture& picture, const layers::SurfaceTable& table) {
    std::vector<char> result;
    for (const MediumRow& row : media_of(picture, table.parts, table.diagonal).rows) {
        result.push_back(row.is_medium.x != 0 ? 1 : 0);
    }
    return result;
}

/// By number of layers: pixels in which so many of other parts are before the first surface of these parts, the last of
/// them opaque.
std::vector<std::size_t> pixels_by_cover(const layers::HostStack& stack, std::span<const char> wanted,
                                         std::span<const char> revealed, std::span<const char> media) {
    std::vector<std::size_t> pixels(static_cast<std::size_t>(stack.layers) + 1, 0);
    for (int y = 0; y < stack.size.y; ++y) {
        for (int x = 0; x < stack.size.x; ++x) {
            std::size_t others = 0, hiding = 0;
            for (int layer = 0; layer < stack.layers; ++layer) {
                const layers::Surface s = stack.at(layer, x, y);
                if (s.depth == 0) {
                    break;
                }
                const std::uint32_t part = stack.table->leaves[s.leaf].part.x;
                if (wanted[part] != 0) {
                    ++pixels[hiding];
                    break;
                }
                if (revealed[part] == 0) {
                    ++others;
                    const bool opaque = stack.table->parts[part].kind == layers::PartKind::Solid && media[part] == 0;
                    hiding = opaque ? others : hiding;
                }
            }
        }
    }
    return pixels;
}

}  // namespace

Revealed layers_to_peel_away(const Picture& picture, const layers::HostStack& stack) {
    const std::vector<char> all = revealed_parts(picture.reveal, stack.table->parts);
    const std::vector<char> media = media_parts(picture, *stack.table);
    Revealed result;
    std::vector<std::vector<std::size_t>> covers;
    for (const RevealedPart& wish : picture.reveal) {
        covers.push_back(pixels_by_cover(stack, revealed_parts(std::span(&wish, 1), stack.table->parts), all, media));
        std::size_t sum = 0;
        for (const std::size_t pixels : covers.back()) {
            sum += pixels;
        }
        std::size_t seen = 0;
        for (std::size_t layers = 0; layers < covers.back().size() && sum > 0; ++layers) {
            seen += covers.back()[layers];
            if (static_cast<double>(seen) >= wish.fraction * static_cast<double>(sum)) {
                result.layers = std::max(result.layers, static_cast<int>(layers));
                break;
            }
        }
    }
    std::size_t seen = 0, sum = 0;
    for (const std::vector<std::size_t>& cover : covers) {
        for (std::size_t layers = 0; layers < cover.size(); ++layers) {
            sum += cover[layers];
            seen += layers <= static_cast<std::size_t>(result.layers) ? cover[layers] : 0;
        }
    }
    result.share = sum == 0 ? 0 : static_cast<double>(seen) / static_cast<double>(sum);
    return result;
}

void peel_away(const Picture& picture, const layers::HostStack& stack, int count, layers::HostStack& kept) {
    const std::vector<char> revealed = revealed_parts(picture.reveal, stack.table->parts);
    const std::vector<char> media = media_parts(picture, *stack.table);
    filter_layers(
        stack,
        [&] {
            return [&, left = count, within = std::vector<std::uint32_t>()](const layers::Surface& s) mutable {
                const std::uint32_t part = stack.table->leaves[s.leaf].part.x;
                if (revealed[part] != 0) {
                    return true;
                }
                // Of a medium that was entered the way up to where it is left goes, too.
                const auto entered = s.leaving ? std::find(within.begin(), within.end(), part) : within.end();
                if (entered != within.end()) {
                    within.erase(entered);
                    --left;
                    return false;
                }
                if (left-- <= 0) {
                    return true;
                }
                if (media[part] != 0 && !s.leaving) {
                    within.push_back(part);
                }
                return false;
            };
        },
        kept);
}

}  // namespace npr
