// What every pass of every style knows of its frame, with OpenGL and without.
#pragma once

#include "npr/settings.h"

namespace npr {

/// Under the names of the uniforms, which npr/frame.glsl declares from the table. Colors are sRGB with straight alpha.
struct FrameValues {
    int layer_count{};
    glm::vec3 center_in_eye{};  ///< Eye coordinates of the origin of plane_rows.
    glm::vec2 jitter{};         ///< Of the sample from the pixel's center, in pixels.
    glm::vec3 background_color{};
    glm::vec3 background_stop{};
    glm::vec3 face_color{};
    glm::vec3 cut_color{};
    glm::vec4 highlight_color{};
    glm::vec4 ghost_color{};
    float section_spacing{};  ///< Of hatching, in world units; 0: none.
    int guard{};              ///< See Picture.
    bool transparent_background{};
    int transparency{};        ///< A Transparency.
    float medium_unit{};       ///< See npr/medium_rows.h.
    glm::vec2 medium_light{};  ///< Ambient and directional.
    float door_size{};         ///< In screen-door: of a surface's samples, in pixels.
    bool door_tilt{};          ///< The same: tilted surfaces are more opaque.
    bool gooch_shading{};      ///< Cool to warm colors in place of light and dark.
    bool shadows_known{};      ///< See npr/cast_shadows.h.
    bool back_faces{};         ///< Of what is seen through, faces away from the eye are seen as well.

    static const SettingsTable<FrameValues>& table();
};

/// `center`: the origin of plane_rows, in the world; `diagonal`: of the scene's box.
[[nodiscard]] FrameValues frame_values(const Picture& picture, const base::View& view, const glm::dvec3& center,
                                       double diagonal, int layers);

}  // namespace npr
