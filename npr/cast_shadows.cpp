#include "npr/cast_shadows.h"

namespace npr {
namespace {

constexpr std::string_view kShadowsLabel = "Cast shadows";

struct LightOfShaders {
    using vec3 = glm::vec3;
#include "npr/light_direction.glsl"
};

}  // namespace

Parameter shadows_cast(bool initial) {
    return Parameter::toggle("shadows", kShadowsLabel, initial);
}

bool casts_shadows(const Picture& picture) {
    return has_on(picture, kShadowsLabel);
}

glm::dvec3 toward_light(const base::View& view) {
    // The eye is turned and moved, never scaled.
    return glm::normalize(glm::transpose(glm::dmat3(view.eye_from_world())) *
                          glm::dvec3(LightOfShaders().kLightDirection));
}

}  // namespace npr
