#include "goldfeather/pixel_walk.h"

#include <algorithm>
#include <limits>

namespace goldfeather {

PixelWalk::PixelWalk(const ExpressionTree& tree, const csg::Scene& scene, std::span<const char> counted_from_behind,
                     int max_layers)
    : scene_(scene),
      counted_from_behind_(counted_from_behind),
      max_layers_(max_layers <= 0 ? std::numeric_limits<std::size_t>::max() : static_cast<std::size_t>(max_layers)),
      state_(tree),
      known_(kRemembered + 1) {}

std::span<const FoundSurface> PixelWalk::walk(std::span<const Fragment> fragments) {
    key_.resize(fragments.size());
    std::uint64_t hash = fragments.size();
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const bool same_event = i > 0 && fragments[i].depth == fragments[i - 1].depth;
        key_[i] = fragments[i].leaf << 1 | (same_event ? 1U : 0U);
        hash = (hash ^ key_[i]) * 0x9e3779b97f4a7c15U;
    }
    Known& known = known_[fragments.size() > kLongest ? kRemembered : hash >> 56];
    if (known.key != key_) {
        known.key = key_;
        evaluate(fragments, known);
    }
    return known.found;
}

void PixelWalk::evaluate(std::span<const Fragment> fragments, Known& known) {
    known.found.clear();
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        // Inside at the near plane is what has an odd number of surfaces behind it.
        if (counted_from_behind_[fragments[i].leaf] != 0) {
            state_.toggle(fragments[i].leaf);
        }
    }
    const auto count = static_cast<std::uint32_t>(fragments.size());
    for (std::uint32_t first = 0; first < count && known.found.size() < max_layers_;) {
        std::uint32_t end = first + 1;
        while (end < count && (key_[end] & 1U) != 0) {
            ++end;
        }
        event(fragments, first, end, known.found);
        first = end;
    }
    // Back to the outside: open meshes and layers that nobody asked for leave something behind.
    for (const Fragment& f : fragments) {
        if (state_.inside_leaf(f.leaf)) {
            state_.toggle(f.leaf);
        }
    }
}

void PixelWalk::event(std::span<const Fragment> fragments, std::uint32_t first, std::uint32_t end,
                      std::vector<FoundSurface>& found) {
    touched_.clear();
    switching_.clear();
    for (std::uint32_t i = first; i < end; ++i) {
        const csg::LeafId leaf = fragments[i].leaf;
        switching_.push_back(leaf);
        if (!state_.toggle(leaf)) {
            continue;
        }
        const csg::PartId part = scene_.leaves[leaf].part;
        if (std::none_of(touched_.begin(), touched_.end(), [&](const TouchedPart& t) { return t.part == part; })) {
            touched_.push_back({part, !state_.inside_part(part)});
        }
    }
    std::erase_if(touched_, [&](const TouchedPart& t) { return state_.inside_part(t.part) == t.before; });
    if (touched_.empty()) {
        return;
    }
    std::sort(switching_.begin(), switching_.end());
    if (touched_.size() > 1) {  // Highlighted parts come first.
        const auto plain = [&](const TouchedPart& t) { return scene_.parts[t.part].kind != csg::PartKind::Highlight; };
        std::sort(touched_.begin(), touched_.end(), [&](const TouchedPart& a, const TouchedPart& b) {
            return plain(a) != plain(b) ? plain(b) : a.part < b.part;
        });
    }
    for (const TouchedPart& t : touched_) {
        if (found.size() == max_layers_) {
            return;
        }
        FoundSurface surface{first, end, 0, false, t.before};
        find_leaf(surface, t.part);
        found.push_back(surface);
    }
}

void PixelWalk::find_leaf(FoundSurface& surface, csg::PartId part) {
    const auto toggle_all = [&] {
        for (const csg::LeafId leaf : switching_) {
            state_.toggle(leaf);
        }
    };
    if (surface.leaving) {
        toggle_all();  // The result's side is before the event.
    }
    for (std::size_t i = 0; i < switching_.size();) {
        const csg::LeafId leaf = switching_[i];
        std::size_t times = 0;
        for (; i < switching_.size() && switching_[i] == leaf; ++i) {
            ++times;
        }
        if (times % 2 == 1 && scene_.leaves[leaf].part == part && state_.responsible(leaf)) {
            surface.leaf = leaf;
            surface.reversed = !state_.inside_leaf(leaf);  // Of a product on its side, but not inside: subtracted.
            break;
        }
    }
    if (surface.leaving) {
        toggle_all();
    }
}

}  // namespace goldfeather
