#include "npr/sorted/blending.h"

#include <algorithm>

namespace npr {
namespace {

/// Red, green, blue and alpha of a factor.
glm::vec4 factor(BlendFactor which, const glm::vec4& src, const glm::vec4& dst, const glm::vec4& constant) {
    switch (which) {
        case BlendFactor::Zero:
            return glm::vec4(0);
        case BlendFactor::One:
            return glm::vec4(1);
        case BlendFactor::SrcColor:
            return src;
        case BlendFactor::OneMinusSrcColor:
            return 1.0F - src;
        case BlendFactor::DstColor:
            return dst;
        case BlendFactor::OneMinusDstColor:
            return 1.0F - dst;
        case BlendFactor::SrcAlpha:
            return glm::vec4(src.a);
        case BlendFactor::OneMinusSrcAlpha:
            return glm::vec4(1 - src.a);
        case BlendFactor::DstAlpha:
            return glm::vec4(dst.a);
        case BlendFactor::OneMinusDstAlpha:
            return glm::vec4(1 - dst.a);
        case BlendFactor::ConstantColor:
            return constant;
        case BlendFactor::OneMinusConstantColor:
            return 1.0F - constant;
        case BlendFactor::ConstantAlpha:
            return glm::vec4(constant.a);
        case BlendFactor::OneMinusConstantAlpha:
            return glm::vec4(1 - constant.a);
        case BlendFactor::SrcAlphaSaturate:
            return glm::vec4(glm::vec3(std::min(src.a, 1 - dst.a)), 1);
    }
    return glm::vec4(0);
}

glm::vec4 combined(BlendEquation equation, const glm::vec4& src, const glm::vec4& src_factor, const glm::vec4& dst,
                   const glm::vec4& dst_factor) {
    switch (equation) {
        case BlendEquation::Add:
            return src * src_factor + dst * dst_factor;
        case BlendEquation::Subtract:
            return src * src_factor - dst * dst_factor;
        case BlendEquation::ReverseSubtract:
            return dst * dst_factor - src * src_factor;
        case BlendEquation::Min:
            return glm::min(src, dst);
        case BlendEquation::Max:
            return glm::max(src, dst);
    }
    return dst;
}

}  // namespace

const std::vector<std::string_view>& blend_factor_names() {
    static const std::vector<std::string_view> names{"zero",
                                                     "one",
                                                     "src-color",
                                                     "one-minus-src-color",
                                                     "dst-color",
                                                     "one-minus-dst-color",
                                                     "src-alpha",
                                                     "one-minus-src-alpha",
                                                     "dst-alpha",
                                                     "one-minus-dst-alpha",
                                                     "constant-color",
                                                     "one-minus-constant-color",
                                                     "constant-alpha",
                                                     "one-minus-constant-alpha",
                                                     "src-alpha-saturate"};
    return names;
}

const std::vector<std::string_view>& blend_equation_names() {
    static const std::vector<std::string_view> names{"add", "subtract", "reverse-subtract", "min", "max"};
    return names;
}

glm::vec4 blend(const Blending& b, glm::vec4 src, const glm::vec4& dst) {
    if (b.premultiplied) {
        src = glm::vec4(glm::vec3(src) * src.a, src.a);
    }
    const glm::vec4 color =
        combined(b.equation, src, factor(b.src, src, dst, b.constant), dst, factor(b.dst, src, dst, b.constant));
    const float alpha = combined(b.alpha_equation, src, factor(b.src_alpha, src, dst, b.constant), dst,
                                 factor(b.dst_alpha, src, dst, b.constant))
                            .a;
    return glm::clamp(glm::vec4(glm::vec3(color), alpha), 0.0F, 1.0F);
}

}  // namespace npr
