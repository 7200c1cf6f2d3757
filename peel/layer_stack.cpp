#include "peel/layer_stack.h"

namespace peel {

void bind(const LayerStack& stack) {
    stack.depth.bind(0);
    stack.surface.bind(1);
    stack.tables->leaves.bind(GL_SHADER_STORAGE_BUFFER, 0);
    stack.tables->planes.bind(GL_SHADER_STORAGE_BUFFER, 1);
}

}  // namespace peel
