#include "peel/layer_upload.h"

#include <algorithm>

namespace peel {

std::vector<LayerUpload::Rectangle> LayerUpload::rectangles(const goldfeather::CpuLayers& layers) {
    constexpr int kSide = goldfeather::CpuLayers::kTileSide;
    std::vector<Rectangle> result(static_cast<std::size_t>(layers.layers));
    const int across = (layers.size.x + kSide - 1) / kSide;
    for (int tile = 0; tile < static_cast<int>(layers.held.size()); ++tile) {
        const glm::ivec2 lo = kSide * glm::ivec2(tile % across, tile / across);
        const Rectangle box{lo, glm::min(lo + kSide, layers.size)};
        const int held = std::min(layers.held[static_cast<std::size_t>(tile)], layers.layers);
        for (int layer = 0; layer < held; ++layer) {
            Rectangle& r = result[static_cast<std::size_t>(layer)];
            r = united(r, box);
        }
    }
    return result;
}

LayerUpload::Rectangle LayerUpload::united(const Rectangle& a, const Rectangle& b) {
    if (a.empty() || b.empty()) {
        return a.empty() ? b : a;
    }
    return {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

LayerStack LayerUpload::upload(const goldfeather::CpuLayers& layers) {
    std::vector<Rectangle> holds = rectangles(layers);
    LayerStack stack;
    const bool again = spare_ && spare_->size == layers.size && spare_->layers == layers.layers;
    if (again) {
        stack = std::move(*spare_);
    } else {
        stack.depth = gl::Texture::make_2d_array(gl_, GL_R32F, layers.size, layers.layers);
        stack.surface = gl::Texture::make_2d_array(gl_, GL_RG32UI, layers.size, layers.layers);
        held_.assign(holds.size(), {glm::ivec2(0), layers.size});  // Everything is to be written once.
    }
    spare_.reset();
    stack.size = layers.size;
    stack.layers = layers.layers;
    stack.complete = layers.complete;
    last_ = stack.depth.id();
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, layers.size.x);
    for (int layer = 0; layer < layers.layers; ++layer) {
        const auto k = static_cast<std::size_t>(layer);
        const Rectangle r = united(holds[k], held_[k]);
        if (r.empty()) {
            continue;
        }
        const goldfeather::CpuLayer& plane = layers.planes[k];
        const std::size_t first = static_cast<std::size_t>(r.lo.y) * static_cast<std::size_t>(layers.size.x) +
                                  static_cast<std::size_t>(r.lo.x);
        const glm::ivec2 size = r.hi - r.lo;
        gl_.TextureSubImage3D(stack.depth.id(), 0, r.lo.x, r.lo.y, layer, size.x, size.y, 1, GL_RED, GL_FLOAT,
                              plane.depth.data() + first);
        gl_.TextureSubImage3D(stack.surface.id(), 0, r.lo.x, r.lo.y, layer, size.x, size.y, 1, GL_RG_INTEGER,
                              GL_UNSIGNED_INT, plane.surface.data() + first);
    }
    gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    held_ = std::move(holds);
    return stack;
}

void LayerUpload::give_back(LayerStack stack) {
    if (stack.depth && stack.depth.id() == last_) {
        stack.tables.reset();
        spare_ = std::move(stack);
    }
}

}  // namespace peel
