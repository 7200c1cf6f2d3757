#include "npr/smooth_shading.h"

#include <algorithm>

namespace npr {
namespace {

constexpr std::string_view kLabel = "Smooth shading";

bool asked(const Parameters& parameters) {
    for (std::size_t i = 0; i < parameters.list().size(); ++i) {
        if (parameters.list()[i].label == kLabel) {
            return std::get<bool>(parameters.at(i));
        }
    }
    return false;
}

}  // namespace

Parameter smooth_surfaces(std::string_view name, bool initial) {
    return Parameter::toggle(name, kLabel, initial);
}

bool shades_smoothly(const Picture& picture) {
    return asked(picture.parameters) || std::any_of(picture.part_styles.begin(), picture.part_styles.end(),
                                                    [](const PartStyle& s) { return asked(s.parameters); });
}

}  // namespace npr
