#include "layers/upload.h"

#include <algorithm>

namespace layers {

std::vector<Upload::Rectangle> Upload::rectangles(const HostStack& from) {
    constexpr int kSide = HostStack::kTileSide;
    std::vector<Rectangle> result(static_cast<std::size_t>(from.layers));
    const int across = (from.size.x + kSide - 1) / kSide;
    for (int tile = 0; tile < static_cast<int>(from.held.size()); ++tile) {
        const glm::ivec2 lo = kSide * glm::ivec2(tile % across, tile / across);
        const Rectangle box{lo, glm::min(lo + kSide, from.size)};
        const int held = std::min(from.held[static_cast<std::size_t>(tile)], from.layers);
        for (int layer = 0; layer < held; ++layer) {
            Rectangle& r = result[static_cast<std::size_t>(layer)];
            r = united(r, box);
        }
    }
    return result;
}

Upload::Rectangle Upload::united(const Rectangle& a, const Rectangle& b) {
    if (a.empty() || b.empty()) {
        return a.empty() ? b : a;
    }
    return {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

TextureStack Upload::textures(const Stack& stack) {
    if (stack.host) {
        return upload(*stack.host);
    }
    forget();
    return std::move(*stack.textures);
}

TextureStack Upload::upload(const HostStack& from) {
    std::vector<Rectangle> holds = rectangles(from);
    TextureStack stack;
    const bool again = spare_ && spare_->size == from.size && spare_->layers == from.layers;
    if (again) {
        stack = std::move(*spare_);
    } else {
        stack.depth = gl::Texture::make_2d_array(gl_, GL_R32F, from.size, from.layers);
        stack.surface = gl::Texture::make_2d_array(gl_, GL_RG32UI, from.size, from.layers);
        held_.assign(holds.size(), {glm::ivec2(0), from.size});  // Everything is to be written once.
    }
    spare_.reset();
    stack.size = from.size;
    stack.layers = from.layers;
    stack.complete = from.complete;
    last_ = stack.depth.id();
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_.PixelStorei(GL_UNPACK_ROW_LENGTH, from.size.x);
    for (int layer = 0; layer < from.layers; ++layer) {
        const auto k = static_cast<std::size_t>(layer);
        const Rectangle r = united(holds[k], held_[k]);
        if (r.empty()) {
            continue;
        }
        const HostLayer& plane = from.planes[k];
        const std::size_t first =
            static_cast<std::size_t>(r.lo.y) * static_cast<std::size_t>(from.size.x) + static_cast<std::size_t>(r.lo.x);
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

void Upload::give_back(TextureStack stack) {
    if (stack.depth && stack.depth.id() == last_) {
        stack.table.reset();
        spare_ = std::move(stack);
    }
}

}  // namespace layers
