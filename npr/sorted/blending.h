// OpenGL's blending, by name (Khronos, OpenGL 4.6, section 17.3.6), for pictures of sorted triangles.
#pragma once

#include <glm/glm.hpp>
#include <string_view>
#include <vector>

namespace npr {

/// In the order of blend_factor_names().
enum class BlendFactor : int {
    Zero,
    One,
    SrcColor,
    OneMinusSrcColor,
    DstColor,
    OneMinusDstColor,
    SrcAlpha,
    OneMinusSrcAlpha,
    DstAlpha,
    OneMinusDstAlpha,
    ConstantColor,
    OneMinusConstantColor,
    ConstantAlpha,
    OneMinusConstantAlpha,
    SrcAlphaSaturate,
};

/// In the order of blend_equation_names().
enum class BlendEquation : int { Add, Subtract, ReverseSubtract, Min, Max };

/// "zero", "one", "src-color", … as OpenGL has them. Those of a second source color are left out: there is none.
[[nodiscard]] const std::vector<std::string_view>& blend_factor_names();
/// "add", "subtract" (source minus destination), "reverse-subtract", "min", "max".
[[nodiscard]] const std::vector<std::string_view>& blend_equation_names();

struct Blending {
    BlendFactor src = BlendFactor::SrcAlpha, dst = BlendFactor::OneMinusSrcAlpha;
    BlendEquation equation = BlendEquation::Add;
    BlendFactor src_alpha = BlendFactor::One, dst_alpha = BlendFactor::OneMinusSrcAlpha;
    BlendEquation alpha_equation = BlendEquation::Add;
    glm::vec4 constant{0};
    bool premultiplied = false;  ///< The source's color is multiplied by its alpha first.
};

/// What is in the buffer after a fragment, clamped to [0, 1].
[[nodiscard]] glm::vec4 blend(const Blending& blending, glm::vec4 src, const glm::vec4& dst);

}  // namespace npr
