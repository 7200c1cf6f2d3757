#include "npr/frame_values.h"

#include <cmath>

#include "npr/samples.h"
#include "npr/screen_door_settings.h"
#include "npr/shine/view_dependent_settings.h"
#include "npr/sorted/sorted_settings.h"

namespace npr {
namespace {

/// 0 where there is none. That of the model's own is 1, 2 or 5 times a power of ten.
float section_spacing(const Sections& sections, double diagonal) {
    if (sections.cuts.empty()) {
        return 0;
    }
    if (sections.spacing != Sections::kOwnSpacing) {
        return static_cast<float>(sections.spacing);
    }
    constexpr double kLinesAcross = 90;
    const double wanted = diagonal / kLinesAcross;
    if (!(wanted > 0) || !std::isfinite(wanted)) {
        return 0;
    }
    const double power = std::pow(10.0, std::floor(std::log10(wanted)));
    const double step = wanted <= power ? 1 : wanted <= 2 * power ? 2 : wanted <= 5 * power ? 5 : 10;
    return static_cast<float>(step * power);
}

}  // namespace

const SettingsTable<FrameValues>& FrameValues::table() {
    static const SettingsTable<FrameValues> all{
        setting<&FrameValues::layer_count>(),     setting<&FrameValues::center_in_eye>(),
        setting<&FrameValues::jitter>(),          setting<&FrameValues::background_color>(),
        setting<&FrameValues::background_stop>(), setting<&FrameValues::face_color>(),
        setting<&FrameValues::cut_color>(),       setting<&FrameValues::highlight_color>(),
        setting<&FrameValues::ghost_color>(),     setting<&FrameValues::section_spacing>(),
        setting<&FrameValues::guard>(),           setting<&FrameValues::transparent_background>(),
        setting<&FrameValues::transparency>(),    setting<&FrameValues::medium_unit>(),
        setting<&FrameValues::medium_light>(),    setting<&FrameValues::door_size>(),
        setting<&FrameValues::door_tilt>(),       setting<&FrameValues::gooch_shading>(),
        setting<&FrameValues::back_faces>(),      setting<&FrameValues::shadows_known>(),
    };
    return all;
}

FrameValues frame_values(const Picture& picture, const base::View& view, const glm::dvec3& center, double diagonal,
                         int layers) {
    FrameValues v;
    v.layer_count = layers;
    // In double precision, since the world's origin may be far away.
    v.center_in_eye = glm::dvec3(view.eye_from_world() * glm::dvec4(center, 1.0));
    v.jitter = view.jitter();
    v.background_color = picture.scheme.background;
    v.background_stop = picture.scheme.background_stop;
    v.face_color = picture.scheme.face;
    v.cut_color = picture.scheme.cut;
    v.highlight_color = picture.scheme.highlight;
    v.ghost_color = picture.scheme.ghost;
    v.section_spacing = section_spacing(picture.sections, diagonal);
    v.guard = picture.guard;
    v.transparent_background = picture.transparent_background;
    v.transparency = static_cast<int>(picture.transparency);
    v.medium_light = {picture.medium_light.ambient, picture.medium_light.directional};
    const auto door = transparency_settings<ScreenDoorSettings>(picture);
    v.door_size = door.size / static_cast<float>(std::sqrt(sample_offsets(picture.samples).size()));
    v.door_tilt = door.silhouettes;
    v.gooch_shading = picture.transparency == Transparency::ViewDependent &&
                      transparency_settings<ViewDependentSettings>(picture).gooch;
    v.back_faces =
        picture.transparency == Transparency::Sorted && transparency_settings<SortedSettings>(picture).back_faces;
    return v;
}

}  // namespace npr
