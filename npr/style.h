// Styles: ways to draw a stack of layers.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string_view>

#include "base/camera.h"
#include "gl/objects.h"
#include "layers/texture_stack.h"
#include "npr/painter/cpu_frame.h"
#include "npr/picture.h"

namespace npr {

/// One sample per pixel of a picture, to be drawn by a style.
struct Frame {
    const Picture& picture;
    const base::View& view;  ///< That `layers` was peeled from, its jitter included.
    const layers::TextureStack& layers;
    /// Of the size of the stack, one RGBA32F attachment: linear light, premultiplied alpha. Undefined before.
    const gl::Framebuffer& target;
    std::stop_token stop{};  ///< Where it is asked for, the style throws base::Stopped; the target is undefined then.
    const gl::Buffer* shine = nullptr;    ///< Of ShineRow (npr/shine/shine.h), in pictures that need them.
    const ColoredMesh* mesh = nullptr;    ///< Of the parts, in pictures that need it.
    int sample = 0;                       ///< Of the picture, from 0.
    const gl::Buffer* shadows = nullptr;  ///< Of ShadowBits (npr/cast_shadows.h), in pictures that need them.
};

/// A way to draw layers. Made once per context, which must be current in every call and outlive the style.
class Style {
  public:
    virtual ~Style() = default;
    Style(const Style&) = delete;
    Style& operator=(const Style&) = delete;

    /// Writes every pixel of the target. The same frame gives the same pixels; noise is anchored to pixels of the
    /// picture or to what its first sample sees, never to the sample's jitter. A stack with fewer or more layers than
    /// needed is drawn as it is.
    virtual void draw(const Frame& frame) = 0;

  protected:
    Style() = default;
};

/// For styles that look for a surface in all layers of the neighbors, whichever layers are drawn.
[[nodiscard]] constexpr int all_layers(bool /*translucent*/) {
    return layers::kAllLayers;
}

/// What is known of a style without a context. pixel_style() and lined_style() (npr/styles) make one of little.
struct StyleInfo {
    std::string_view name;   ///< For the command line.
    std::string_view label;  ///< For the window.
    std::span<const Parameter> parameters;
    /// Compiles the style's programs; throws gl::Error.
    std::function<std::unique_ptr<Style>(const gl::Functions& gl)> make;
    /// The same without OpenGL. One at a time paints: it may keep what does not change from frame to frame.
    std::function<Paint()> make_paint;
    /// How many layers the style looks at: the first so many, or all (0). `translucent`: parts of the scene are not
    /// opaque (`%`, `#`, alpha below 1).
    int (*layers)(bool translucent) = all_layers;
    /// How far from beyond the border lines and strokes reach into a picture, in pixels. None: nothing does.
    std::function<int(const Picture& picture)> reach{};
};

/// All styles; the first is the default.
[[nodiscard]] std::span<const StyleInfo> styles();

/// Null where there is no style of that name.
[[nodiscard]] const StyleInfo* find_style(std::string_view name);

}  // namespace npr
