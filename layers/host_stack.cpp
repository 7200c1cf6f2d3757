#include "layers/host_stack.h"

#include <algorithm>

namespace layers {

void HostStack::resize(glm::ivec2 to) {
    if (size == to) {
        return;
    }
    const glm::ivec2 tiles = (to + kTileSide - 1) / kTileSide;
    size = to;
    layers = 0;
    planes.clear();
    held.assign(static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y), 0);
    counts.assign(static_cast<std::size_t>(to.x) * static_cast<std::size_t>(to.y), 0);
}

void HostStack::reserve(std::size_t count) {
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    while (planes.size() < count) {
        planes.push_back({std::vector<float>(pixels), std::vector<glm::uvec2>(pixels, {kNoSurface, 0})});
    }
}

std::vector<Surface> HostStack::surfaces() const {
    std::vector<Surface> all;
    all.reserve(counts.size() * static_cast<std::size_t>(layers));
    for (int layer = 0; layer < layers; ++layer) {
        const HostLayer& plane = planes[static_cast<std::size_t>(layer)];
        std::transform(plane.depth.begin(), plane.depth.end(), plane.surface.begin(), std::back_inserter(all), decode);
    }
    return all;
}

void HostStack::count() {
    for (std::size_t pixel = 0; pixel < counts.size(); ++pixel) {
        int& of_pixel = counts[pixel];
        of_pixel = 0;
        while (of_pixel < layers && planes[static_cast<std::size_t>(of_pixel)].surface[pixel].x != kNoSurface) {
            ++of_pixel;
        }
    }
    count_tiles();
}

void HostStack::count_tiles() {
    const int across = (size.x + kTileSide - 1) / kTileSide;
    std::fill(held.begin(), held.end(), 0);
    std::size_t pixel = 0;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x, ++pixel) {
            int& of_tile = held[static_cast<std::size_t>(y / kTileSide * across + x / kTileSide)];
            of_tile = std::max(of_tile, counts[pixel]);
        }
    }
}

void leave_out_sparse_layers(HostStack& stack, double minimal_fraction) {
    if (!(minimal_fraction > 0)) {
        return;
    }
    std::vector<std::size_t> pixels(static_cast<std::size_t>(stack.layers) + 1, 0);  // By number of layers.
    for (const int count : stack.counts) {
        ++pixels[static_cast<std::size_t>(std::min(count, stack.layers))];
    }
    const double least = minimal_fraction * static_cast<double>(stack.counts.size());
    std::size_t holding = 0;  // Pixels that hold a surface in the last layer.
    while (stack.layers > 1) {
        holding += pixels[static_cast<std::size_t>(stack.layers)];
        if (static_cast<double>(holding) >= least) {
            break;
        }
        --stack.layers;
        stack.complete = false;
    }
}

}  // namespace layers
