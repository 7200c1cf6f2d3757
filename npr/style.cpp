#include "npr/style.h"

#include <algorithm>
#include <array>

namespace npr {

using StyleMaker = StyleInfo();
// Each in the file of its name in npr/styles/.
StyleMaker shaded_style, edges_style, blueprint_style, xray_style, sketch_style, radiograph_style, lines_style,
    gooch_style, toon_style, hatch_style, stipple_style, tech_style, ntone_style, blueprint_lines_style, chalk_style,
    strokes_style, sketch_blueprint_style;

std::span<const StyleInfo> styles() {
    static const std::array all{shaded_style(),  edges_style(),           blueprint_style(),
                                xray_style(),    sketch_style(),          radiograph_style(),
                                lines_style(),   gooch_style(),           toon_style(),
                                hatch_style(),   stipple_style(),         tech_style(),
                                ntone_style(),   blueprint_lines_style(), chalk_style(),
                                strokes_style(), sketch_blueprint_style()};
    return all;
}

const StyleInfo* find_style(std::string_view name) {
    const auto all = styles();
    const auto found = std::find_if(all.begin(), all.end(), [&](const StyleInfo& s) { return s.name == name; });
    return found == all.end() ? nullptr : &*found;
}

void Picture::draw_as(const StyleInfo& info) {
    style = &info;
    parameters = Parameters(info.parameters);
}

bool has_on(const Picture& picture, std::string_view label) {
    const auto on = [&](const Parameters& parameters) {
        for (std::size_t i = 0; i < parameters.list().size(); ++i) {
            if (parameters.list()[i].label == label) {
                return std::get<bool>(parameters.at(i));
            }
        }
        return false;
    };
    return on(picture.parameters) || std::any_of(picture.part_styles.begin(), picture.part_styles.end(),
                                                 [&](const PartStyle& each) { return on(each.parameters); });
}

Picture default_picture() {
    Picture picture;
    picture.draw_as(styles().front());
    picture.scheme = color_schemes().front();
    return picture;
}

}  // namespace npr
