#include "npr/guard_band.h"

#include <algorithm>
#include <cmath>

#include "npr/style.h"

namespace npr {
namespace {

constexpr int kAboutAnEdge = 8, kWidestBand = 64, kLargestSide = 16384;

int reach_of(const Picture& picture) {
    return picture.style != nullptr && picture.style->reach ? picture.style->reach(picture) : 0;
}

}  // namespace

Picture with_guard_band(const Picture& picture) {
    int reach = reach_of(picture);
    for (const PartStyle& part : picture.part_styles) {
        Picture alone = picture;
        alone.style = part.style;
        alone.parameters = part.parameters;
        reach = std::max(reach, reach_of(alone));
    }
    reach = std::min(reach, kWidestBand);
    Picture wide = picture;
    const glm::ivec2 size = picture.size + 2 * reach;
    if (reach == 0 || std::max(size.x, size.y) > kLargestSide) {
        return wide;
    }
    const double larger = static_cast<double>(size.y) / picture.size.y;
    wide.size = size;
    wide.camera.fov = glm::degrees(2 * std::atan(larger * std::tan(glm::radians(picture.camera.fov) / 2)));
    wide.guard = reach;
    return wide;
}

int reach_of_lines(float width) {
    return static_cast<int>(std::ceil(0.5F * width + 0.5F)) + kAboutAnEdge;
}

}  // namespace npr
