#include "npr/edges/line_types.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace npr {
namespace {

constexpr std::array kKinds{LineKind::ColorBorder, LineKind::Crease, LineKind::Intersection, LineKind::PartBorder,
                            LineKind::Silhouette};
static_assert(kKinds.size() == LineTypes::kKinds);

constexpr float kDash = 6, kDashGap = 3.5F, kDot = 1.5F, kDotGap = 3.5F;  // Times the width of hidden lines.

}  // namespace

LineTypes plain_types(const LinedSettings& settings) {
    LineTypes types;
    for (const LineKind kind : kKinds) {
        const float strength = kind == LineKind::Silhouette ? settings.profile_strength : settings.inner_strength;
        const float width = kind == LineKind::Silhouette ? 1 : settings.inner_share;
        types.of(kind, Visibility::Visible) = {width, strength};
        for (const Visibility hidden : {Visibility::Hidden, Visibility::DeeplyHidden}) {
            types.of(kind, hidden) = {settings.hidden_share, strength};
        }
    }
    return types;
}

void LinedSettings::complete_lines(const Picture& picture) {
    inner_width = inner_share * width;
    hidden_width = hidden_share * width;
    const LineTypes plain = plain_types(*this);
    types = plain;
    if (dashes) {
        for (const LineKind kind : kKinds) {
            LineType& hidden = types.of(kind, Visibility::Hidden);
            LineType& deep = types.of(kind, Visibility::DeeplyHidden);
            std::tie(hidden.dash, hidden.gap) = std::pair(kDash * hidden_width, kDashGap * hidden_width);
            std::tie(deep.dash, deep.gap) = std::pair(kDot * hidden_width, kDotGap * hidden_width);
        }
    }
    facts = types != plain;
    const base::Camera& camera = picture.camera;
    const double height = 2 * camera.distance * std::tan(glm::radians(camera.fov) / 2);
    line_unit = std::max(static_cast<float>(height / picture.size.y), 1e-30F);
}

Parameter line_dashes() {
    return Parameter::toggle("dashes", "Dashes behind solids", false);
}

}  // namespace npr
