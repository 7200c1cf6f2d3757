// A stack of layers on either side.
#pragma once

#include <memory>

namespace layers {

struct HostStack;
struct TextureStack;

/// One of the two: in main memory, or in textures.
struct Stack {
    std::shared_ptr<HostStack> host;
    std::shared_ptr<TextureStack> textures;
};

}  // namespace layers
