#include "npr/frame_values.h"

namespace npr {

const SettingsTable<FrameValues>& FrameValues::table() {
    static const SettingsTable<FrameValues> all{
        setting<&FrameValues::layer_count>(),     setting<&FrameValues::center_in_eye>(),
        setting<&FrameValues::jitter>(),          setting<&FrameValues::background_color>(),
        setting<&FrameValues::background_stop>(), setting<&FrameValues::face_color>(),
        setting<&FrameValues::cut_color>(),       setting<&FrameValues::highlight_color>(),
        setting<&FrameValues::ghost_color>(),     setting<&FrameValues::transparent_background>(),
    };
    return all;
}

FrameValues frame_values(const Picture& picture, const base::View& view, const glm::dvec3& center, int layers) {
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
    v.transparent_background = picture.transparent_background;
    return v;
}

}  // namespace npr
