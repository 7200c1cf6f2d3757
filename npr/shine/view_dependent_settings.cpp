#include "npr/shine/view_dependent_settings.h"

namespace npr {

const SettingsTable<ViewDependentSettings>& ViewDependentSettings::table() {
    using S = ViewDependentSettings;
    static const SettingsTable<S> all{
        setting<&S::method>(Parameter::choice("until", "Opaque parts until", static_cast<int>(ShineMethod::FrontFace),
                                              {"back-face", "front-face"})),
        setting<&S::falloff>(Parameter::number("falloff", "Falloff from silhouettes", 0.5F, 0, 1)),
        setting<&S::background>(Parameter::number("background", "Background seen through", 0.5F, 0, 1)),
        setting<&S::opaque>(Parameter::number("opaque", "Opaque parts seen through", 1, 0, 1)),
        setting<&S::gooch>(Parameter::toggle("gooch", "Cool to warm shading", true)),
        setting<&S::silhouette_width>(Parameter::number("silhouettes", "Width of silhouettes", 1, 0, 8)),
        setting<&S::opacity>(Parameter::choice("opacity", "Opacity found for", static_cast<int>(ShineOpacity::Pixels),
                                               {"pixels", "vertices"})),
    };
    return all;
}

bool shines_by_vertex(const Picture& picture) {
    return picture.transparency == Transparency::ViewDependent &&
           transparency_settings<ViewDependentSettings>(picture).opacity == static_cast<int>(ShineOpacity::Vertices);
}

}  // namespace npr
