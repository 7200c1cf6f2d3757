#include "npr/sorted/sorted_settings.h"

namespace npr {

const SettingsTable<SortedSettings>& SortedSettings::table() {
    using S = SortedSettings;
    const auto factor = [](std::string_view name, std::string_view label, BlendFactor initial) {
        return Parameter::choice(name, label, static_cast<int>(initial), blend_factor_names());
    };
    const auto equation = [](std::string_view name, std::string_view label) {
        return Parameter::choice(name, label, static_cast<int>(BlendEquation::Add), blend_equation_names());
    };
    static const SettingsTable<S> all{
        setting<&S::order>(Parameter::choice("order", "Back to front", static_cast<int>(SortOrder::Triangles),
                                             {"triangles", "objects", "parts", "none"})),
        setting<&S::depth_writes>(Parameter::toggle("depth", "Depth writes", false)),
        setting<&S::back_faces>(Parameter::toggle("back-faces", "Back faces", false)),
        setting<&S::src>(factor("src", "Source factor", BlendFactor::SrcAlpha)),
        setting<&S::dst>(factor("dst", "Destination factor", BlendFactor::OneMinusSrcAlpha)),
        setting<&S::equation>(equation("equation", "Equation")),
        setting<&S::src_alpha>(factor("src-alpha", "Source factor of alpha", BlendFactor::One)),
        setting<&S::dst_alpha>(factor("dst-alpha", "Destination factor of alpha", BlendFactor::OneMinusSrcAlpha)),
        setting<&S::alpha_equation>(equation("alpha-equation", "Equation of alpha")),
        setting<&S::constant>(Parameter::color("constant", "Constant color", glm::vec3(0))),
        setting<&S::constant_alpha>(Parameter::number("constant-alpha", "Constant alpha", 0, 0, 1)),
        setting<&S::premultiplied>(Parameter::toggle("premultiplied", "Premultiplied source", false)),
    };
    return all;
}

Blending SortedSettings::blending() const {
    return {static_cast<BlendFactor>(src),        static_cast<BlendFactor>(dst),
            static_cast<BlendEquation>(equation), static_cast<BlendFactor>(src_alpha),
            static_cast<BlendFactor>(dst_alpha),  static_cast<BlendEquation>(alpha_equation),
            glm::vec4(constant, constant_alpha),  premultiplied};
}

}  // namespace npr
