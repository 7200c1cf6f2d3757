#include "npr/smooth_shading.h"

namespace npr {
namespace {

constexpr std::string_view kSmoothLabel = "Smooth shading";

}  // namespace

Parameter smooth_surfaces(std::string_view name, bool initial) {
    return Parameter::toggle(name, kSmoothLabel, initial);
}

bool shades_smoothly(const Picture& picture) {
    return has_on(picture, kSmoothLabel);
}

}  // namespace npr
