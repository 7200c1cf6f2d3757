// Stacks of some surfaces of another stack.
#pragma once

#include <algorithm>
#include <stop_token>

#include "base/parallel.h"
#include "layers/host_stack.h"

namespace npr {

/// Fills `kept` with the surfaces for which `make_filter()`(surface) is true, nearest first; a filter is made anew for
/// each pixel. What was in `kept` is taken away; its memory is used again.
template <typename MakeFilter>
void filter_layers(const layers::HostStack& all, const MakeFilter& make_filter, layers::HostStack& kept,
                   const std::stop_token& stop = {}) {
    kept.resize(all.size);
    kept.table = all.table;
    kept.reserve(static_cast<std::size_t>(all.layers));
    kept.layers = all.layers;
    kept.complete = all.complete;
    base::for_each_index(
        all.size.y,
        [&] {
            return [&](int y) {
                const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(all.size.x);
                for (std::size_t pixel = first; pixel < first + static_cast<std::size_t>(all.size.x); ++pixel) {
                    auto filter = make_filter();
                    std::size_t to = 0;
                    for (std::size_t from = 0; from < static_cast<std::size_t>(all.layers); ++from) {
                        const glm::uvec2 ids = all.planes[from].surface[pixel];
                        if (ids.x == layers::kNoSurface) {
                            break;
                        }
                        const layers::Surface s = layers::decode(all.planes[from].depth[pixel], ids);
                        if (filter(s)) {
                            kept.planes[to].surface[pixel] = ids;
                            kept.planes[to++].depth[pixel] = s.depth;
                        }
                    }
                    int& count = kept.counts[pixel];
                    const auto before = static_cast<std::size_t>(count);
                    count = static_cast<int>(to);
                    for (; to < before; ++to) {
                        kept.planes[to].surface[pixel] = {layers::kNoSurface, 0};
                        kept.planes[to].depth[pixel] = 0;
                    }
                }
            };
        },
        0, stop);
    kept.count_tiles();
    kept.layers = std::max(1, kept.held.empty() ? 1 : *std::max_element(kept.held.begin(), kept.held.end()));
}

}  // namespace npr
