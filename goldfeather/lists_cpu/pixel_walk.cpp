#include "goldfeather/lists_cpu/pixel_walk.h"

#include <algorithm>
#include <limits>

namespace goldfeather {

namespace {

/// What passing the surface adds to the winding number.
std::int32_t step_of(const Fragment& f) {
    return f.from_behind() ? -1 : 1;
}

}  // namespace

PixelWalk::PixelWalk(const ExpressionTree& tree, const csg::Scene& scene, std::span<const std::uint32_t> ranks,
                     std::span<const char> counted_from_behind, std::span<const char> wound, int max_layers)
    : tree_(tree),
      scene_(scene),
      ranks_(ranks),
      counted_from_behind_(counted_from_behind),
      wound_(wound),
      any_wound_(std::find(wound.begin(), wound.end(), char{1}) != wound.end()),
      winding_(any_wound_ ? wound.size() : 0, 0),
      max_layers_(max_layers <= 0 ? std::numeric_limits<std::size_t>::max() : static_cast<std::size_t>(max_layers)),
      state_(tree),
      known_(kRemembered + 1) {}

std::span<const FoundSurface> PixelWalk::walk(std::span<const Fragment> fragments) {
    key_.resize(fragments.size());
    std::uint64_t hash = fragments.size();
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        const bool same_event = i > 0 && fragments[i].depth == fragments[i - 1].depth;
        const Fragment& f = fragments[i];
        key_[i] = f.leaf_and_side << 1 | (same_event ? 1U : 0U);
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
    enter_from_behind(fragments);
    const auto count = static_cast<std::uint32_t>(fragments.size());
    for (std::uint32_t first = 0; first < count && known.found.size() < max_layers_;) {
        std::uint32_t end = first + 1;
        while (end < count && (key_[end] & 1U) != 0) {
            ++end;
        }
        if (end == first + 1) {
            single_event(fragments[first], first, known.found);
        } else {
            event(fragments, first, end, known.found);
        }
        first = end;
    }
    if (state_.entered() != 0) {  // By open meshes, or where layers have not been asked for.
        if (any_wound_) {
            for (const Fragment& f : fragments) {
                winding_[f.leaf()] = 0;
            }
        }
        leave_all(fragments);
    }
}

bool PixelWalk::turns(csg::LeafId leaf, std::int32_t step) {
    if (!any_wound_ || wound_[leaf] == 0) {
        return true;
    }
    const bool outside = winding_[leaf] == 0;
    winding_[leaf] += step;
    return outside != (winding_[leaf] == 0);
}

/// Inside at the near plane is what has an odd number of surfaces behind it, or, counted with their directions, some.
void PixelWalk::enter_from_behind(std::span<const Fragment> fragments) {
    switching_.clear();
    for (const Fragment& f : fragments) {
        if (counted_from_behind_[f.leaf()] != 0 && turns(f.leaf(), -step_of(f))) {
            switching_.push_back(f.leaf());
        }
    }
    if (!switching_.empty()) {
        toggle_switching();
    }
}

/// Back to the outside.
void PixelWalk::leave_all(std::span<const Fragment> fragments) {
    if (fragments.size() <= kOneByOne) {
        for (const Fragment& f : fragments) {
            if (state_.inside_leaf(f.leaf())) {
                state_.toggle(f.leaf());
            }
        }
        return;
    }
    switching_.clear();
    for (const Fragment& f : fragments) {
        if (state_.inside_leaf(f.leaf())) {
            switching_.push_back(f.leaf());
        }
    }
    std::sort(switching_.begin(), switching_.end());
    switching_.erase(std::unique(switching_.begin(), switching_.end()), switching_.end());
    toggle_switching();
}

void PixelWalk::toggle_switching() {
    changed_.clear();
    if (switching_.size() > kOneByOne) {
        state_.toggle(switching_, changed_);
        return;
    }
    for (const csg::LeafId leaf : switching_) {
        if (!state_.toggle(leaf)) {
            continue;
        }
        // There and back again is no change.
        const csg::PartId part = scene_.leaves[leaf].part;
        const auto known = std::find(changed_.begin(), changed_.end(), part);
        if (known == changed_.end()) {
            changed_.push_back(part);
        } else {
            changed_.erase(known);
        }
    }
}

/// One leaf by itself that turns its part has turned every gate on the way, so it is responsible on the result's side.
void PixelWalk::single_event(const Fragment& fragment, std::uint32_t at, std::vector<FoundSurface>& found) {
    const csg::LeafId leaf = fragment.leaf();
    if (turns(leaf, step_of(fragment)) && state_.toggle(leaf)) {
        const bool complement = tree_.literal(leaf).complement;
        found.push_back({at, at + 1, leaf, complement, state_.inside_leaf(leaf) == complement});
    }
}

void PixelWalk::event(std::span<const Fragment> fragments, std::uint32_t first, std::uint32_t end,
                      std::vector<FoundSurface>& found) {
    switching_.clear();
    for (std::uint32_t i = first; i < end; ++i) {
        if (turns(fragments[i].leaf(), step_of(fragments[i]))) {
            switching_.push_back(fragments[i].leaf());
        }
    }
    toggle_switching();
    if (changed_.empty()) {
        return;
    }
    std::sort(switching_.begin(), switching_.end(), [&](csg::LeafId a, csg::LeafId b) {
        const csg::PartId of_a = scene_.leaves[a].part, of_b = scene_.leaves[b].part;
        return of_a != of_b ? of_a < of_b : a < b;
    });
    if (changed_.size() > 1) {
        std::sort(changed_.begin(), changed_.end(),
                  [&](csg::PartId a, csg::PartId b) { return ranks_[a] < ranks_[b]; });
    }
    const std::size_t begin = found.size();
    bool leaving = false;
    for (const csg::PartId part : changed_) {
        if (found.size() == max_layers_) {
            break;
        }
        found.push_back({first, end, 0, false, !state_.inside_part(part)});
        if (found.back().leaving) {
            leaving = true;
        } else {
            find_leaf(found.back(), part);
        }
    }
    if (!leaving) {
        return;
    }
    // The result's side of what is left is before the event.
    left_.clear();
    for (std::size_t i = begin; i < found.size(); ++i) {
        left_.push_back(changed_[i - begin]);
    }
    toggle_switching();
    for (std::size_t i = begin; i < found.size(); ++i) {
        if (found[i].leaving) {
            find_leaf(found[i], left_[i - begin]);
        }
    }
    toggle_switching();
}

void PixelWalk::find_leaf(FoundSurface& surface, csg::PartId part) {
    auto at = std::partition_point(switching_.begin(), switching_.end(),
                                   [&](csg::LeafId leaf) { return scene_.leaves[leaf].part < part; });
    while (at != switching_.end() && scene_.leaves[*at].part == part) {
        const csg::LeafId leaf = *at;
        std::size_t times = 0;
        for (; at != switching_.end() && *at == leaf; ++at) {
            ++times;
        }
        if (times % 2 == 1 && state_.responsible(leaf)) {
            surface.leaf = leaf;
            surface.reversed = !state_.inside_leaf(leaf);  // Of a product on its side, but not inside: subtracted.
            return;
        }
    }
}

}  // namespace goldfeather
