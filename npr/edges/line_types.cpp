#include "npr/edges/line_types.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace npr {
namespace {

constexpr std::array kKinds{LineKind::ColorBorder, LineKind::Crease,     LineKind::Intersection,
                            LineKind::PartBorder,  LineKind::Silhouette, LineKind::SectionEdge};
static_assert(kKinds.size() == LineTypes::kKinds);

/// Lengths, times the width of hidden lines.
struct Patterns {
    float dash, dash_gap, dot, dot_gap;
};
constexpr Patterns kOnScreens{6, 3.5F, 1.5F, 3.5F};
constexpr Patterns kOnPaper{12, 3, 0.5F, 3};  // ISO 128-2, lines 02 and 07.

bool is_in_millimeters(const Picture& picture) {
    const auto i = picture.parameters.find("width");
    return i && picture.parameters.in_millimeters(*i);
}

}  // namespace

LineTypes plain_types(const LinedSettings& settings) {
    LineTypes types;
    for (const LineKind kind : kKinds) {
        const bool outline = kind == LineKind::Silhouette || kind == LineKind::SectionEdge;
        const float strength = outline ? settings.profile_strength : settings.inner_strength;
        const float width = outline ? 1 : settings.inner_share;
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
        const Patterns lengths = is_in_millimeters(picture) ? kOnPaper : kOnScreens;
        for (const LineKind kind : kKinds) {
            LineType& hidden = types.of(kind, Visibility::Hidden);
            LineType& deep = types.of(kind, Visibility::DeeplyHidden);
            std::tie(hidden.dash, hidden.gap) = std::pair(lengths.dash * hidden_width, lengths.dash_gap * hidden_width);
            std::tie(deep.dash, deep.gap) = std::pair(lengths.dot * hidden_width, lengths.dot_gap * hidden_width);
        }
    }
    const float cut = picture.sections.cuts.empty() || hard ? 1 : section_share;
    types.of(LineKind::SectionEdge, Visibility::Visible).width = cut;
    clearances = halo > 0 || taper_ends > 0;
    halo_gap = halo > 0 ? std::min(halo + 0.5F * width, shader::LineCode().kClear - 0.5F) : 0;
    facts = types != plain || clearances || taper > 0;
    if (cut > 1) {  // The widest lines are the measure of all.
        width *= cut;
        for (LineType& type : types.rows) {
            type.width /= cut;
        }
    }
    const base::Camera& camera = picture.camera;
    const double height = 2 * camera.distance * std::tan(glm::radians(camera.fov) / 2);
    line_unit = std::max(static_cast<float>(height / picture.size.y), 1e-30F);
}

Parameter line_dashes() {
    return Parameter::toggle("dashes", "Dashes behind solids", false);
}

}  // namespace npr
