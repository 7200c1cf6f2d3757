// Layers from main memory to textures.
#pragma once

#include <optional>
#include <vector>

#include "layers/host_stack.h"
#include "layers/texture_stack.h"

namespace layers {

/// Uploads what there is: of each layer the rectangle of the tiles that hold a surface in it. Textures that were given
/// back are used again, and only what they held before is cleared; deep layers mostly hold little.
class Upload {
  public:
    /// `gl` must outlive the object.
    explicit Upload(const gl::Functions& gl) : gl_(gl) {}

    /// The stack in textures, without its table: as it is, or uploaded.
    [[nodiscard]] TextureStack textures(const Stack& stack);
    /// A stack without its table.
    [[nodiscard]] TextureStack upload(const HostStack& stack);
    /// Keeps the textures of the stack uploaded last for the next one. Another stack is dropped.
    void give_back(TextureStack stack);
    /// Takes nothing back until the next upload: names of textures may go to others meanwhile.
    void forget() {
        spare_.reset();
        last_ = 0;
    }

  private:
    struct Rectangle {
        glm::ivec2 lo{0}, hi{0};  ///< Pixels, lo inclusive, hi exclusive; lo = hi where it is empty.
        [[nodiscard]] bool empty() const { return lo.x >= hi.x; }
    };
    [[nodiscard]] static std::vector<Rectangle> rectangles(const HostStack& stack);
    [[nodiscard]] static Rectangle united(const Rectangle& a, const Rectangle& b);

    const gl::Functions& gl_;
    std::vector<Rectangle> held_;        ///< By the textures uploaded last.
    std::optional<TextureStack> spare_;  ///< Those textures, when they have come back.
    GLuint last_ = 0;                    ///< Name of the depth texture uploaded last.
};

}  // namespace layers
