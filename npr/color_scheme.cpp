#include "npr/color_scheme.h"

#include <algorithm>
#include <array>

namespace npr {
namespace {

constexpr glm::vec3 rgb(unsigned hex) {
    return {static_cast<float>(hex >> 16 & 255U) / 255.0F, static_cast<float>(hex >> 8 & 255U) / 255.0F,
            static_cast<float>(hex & 255U) / 255.0F};
}

/// In the plane most schemes have the same colors.
constexpr ColorScheme scheme(std::string_view name, unsigned background, unsigned face, unsigned cut,
                             unsigned face_2d = 0x00bf99, unsigned edge_2d = 0xff0000) {
    return {name,
            rgb(background),
            rgb(background),
            rgb(face),
            rgb(cut),
            rgb(face_2d),
            rgb(edge_2d),
            glm::vec4(rgb(0xff5151), 128.0F / 255.0F),
            glm::vec4(rgb(0xb4b4b4), 128.0F / 255.0F)};
}

constexpr ColorScheme clear_sky() {
    ColorScheme s = scheme("ClearSky", 0x87ceeb, 0xf9d72c, 0x9dcb51);
    s.background_stop = rgb(0xc9e9f6);
    return s;
}

constexpr std::array kSchemes{
    scheme("Cornfield", 0xffffe5, 0xf9d72c, 0x9dcb51),
    scheme("Metallic", 0xaaaaff, 0xddddff, 0xdd22dd),
    scheme("Sunset", 0xaa4444, 0xffaaaa, 0x882233),
    scheme("Starnight", 0x000000, 0xffffe0, 0x00ffff, 0x9370db, 0xff00ff),
    scheme("BeforeDawn", 0x333333, 0xcccccc, 0x5563dd),
    scheme("Nature", 0xfafafa, 0x16a085, 0xdbf4da),
    scheme("DeepOcean", 0x333333, 0xeeeeee, 0x0babc8, 0x9370db, 0xff00ff),
    scheme("Solarized", 0xfdf6e3, 0xb58800, 0x882233, 0x6c71c4, 0xb58800),
    scheme("Tomorrow", 0xf8f8f8, 0x4271ae, 0xf5871f, 0x718c00, 0xc82829),
    scheme("Tomorrow Night", 0x1d1f21, 0x81a2be, 0xde935f, 0xb5bd68, 0xcc6666),
    scheme("Monotone", 0xffffe5, 0xf9d72c, 0xf9d72c),
    clear_sky(),
};

}  // namespace

std::span<const ColorScheme> color_schemes() {
    return kSchemes;
}

const ColorScheme* find_color_scheme(std::string_view name) {
    const auto* found =
        std::find_if(kSchemes.begin(), kSchemes.end(), [&](const ColorScheme& s) { return s.name == name; });
    return found == kSchemes.end() ? nullptr : &*found;
}

}  // namespace npr
