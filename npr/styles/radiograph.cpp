// The thickness of what lies behind each pixel.
#include "npr/styles/radiograph.h"

#include "npr/styles/pixel_style.h"

namespace npr {
namespace {

struct Settings {
    int part{};     ///< 0: all of the solid; else the number of the part.
    float range{};  ///< Millimeters of the full tone; 0: half the scene's diagonal.
    int colors{};   ///< See npr/styles/radiograph_tones.glsl.
    bool legend{};  ///< For whoever writes the picture.

    static const SettingsTable<Settings>& table() {
        static const SettingsTable<Settings> all{
            setting<&Settings::part>(Parameter::integer("part", "Part by its number (0: all)", 0, 0, 100'000)),
            setting<&Settings::range>(
                Parameter::number("range", "Millimeters of the full tone (0: the most)", 0, 0, 1e6F)),
            setting<&Settings::colors>(Parameter::choice("colors", "Tones", 0, {"film", "paper", "heat", "values"})),
            setting<&Settings::legend>(Parameter::toggle("legend", "Legend in pictures written", true)),
        };
        return all;
    }
};

using namespace glm;  // As shader files do.

struct Tones {
#include "npr/styles/radiograph_tones.glsl"
};

struct RadiographPixels : shader::Frame, Settings {
    RadiographPixels(const CpuFrame& frame, const Settings& s) : Frame(frame), Settings(s) {}
#include "npr/styles/radiograph.glsl"

    void begin(int /*tile*/) {}
    glm::vec4 pixel(glm::ivec2 p) {
        return radiograph(p);
    }
    [[nodiscard]] bool as_left(glm::ivec2 p) const {
        return surface_ids(p, 0).x == kNoSurface && same_surfaces(p, {p.x - 1, p.y});
    }
};

}  // namespace

glm::vec3 radiograph_tone(int colors, float share) {
    return Tones().radiograph_tone(colors, share);
}

StyleInfo radiograph_style() {
    return pixel_style<Settings, RadiographPixels>({"radiograph", "Radiograph", "npr/styles/radiograph.frag"});
}

}  // namespace npr
