#include "npr/medium_rows.h"

#include <algorithm>
#include <cmath>

#include "npr/part_style.h"

namespace npr {
namespace {

struct MediumHalf {
    using vec3 = glm::vec3;
    using vec4 = glm::vec4;
    using ivec4 = glm::ivec4;
#include "peel/composite.glsl"
#include "peel/media.glsl"
};

/// The unit is the largest attenuation by this: fine enough for media that are a million times thinner, and 2^15 of
/// the densest may overlap.
constexpr double kMostUnits = 1 << 30;
/// Per millimeter, by the scene's diagonal: as good as opaque.
constexpr double kDensest = 1e6;

}  // namespace

double attenuation_of(double opacity, double thickness) {
    return -std::log1p(-std::clamp(opacity, 0.0, 1 - 1e-12)) / thickness;
}

MediumTable media_of(const Picture& picture, std::span<const layers::PartLook> parts, double diagonal) {
    MediumTable media;
    media.rows.resize(std::max<std::size_t>(parts.size(), 1));
    if (picture.transparency != Transparency::Volume) {
        return media;
    }
    std::vector<glm::dvec4> densities(parts.size(), glm::dvec4(0));
    double most = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const layers::PartLook& part = parts[i];
        bool is_medium = part.kind == layers::PartKind::Translucent;
        double attenuation = attenuation_of(part.color.a, kMediumThickness * diagonal);
        glm::dvec3 albedo;
        for (int c = 0; c < 3; ++c) {
            albedo[c] = std::min(part.color[c] >= 0 ? part.color[c] : picture.scheme.face[c], 1.0F);
        }
        for (const PartMedium& given : picture.media) {
            if (names_part(given.part, part.name)) {
                attenuation = given.attenuation ? *given.attenuation : attenuation;
                is_medium = true;
                albedo = given.albedo ? glm::dvec3(*given.albedo) : albedo;
            }
        }
        if (!is_medium) {
            continue;
        }
        media.rows[i].is_medium.x = 1;
        attenuation = std::min(attenuation, kDensest / diagonal);
        densities[i] = glm::dvec4(attenuation * albedo, attenuation);
        most = std::max(most, attenuation);
    }
    if (most == 0) {
        return media;
    }
    const double unit = most / kMostUnits;
    constexpr auto kHalf = static_cast<int>(MediumHalf().kMediumHalf);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            const int units = static_cast<int>(std::lround(densities[i][c] / unit));
            media.rows[i].high[c] = units / kHalf;
            media.rows[i].low[c] = units % kHalf;
        }
    }
    media.unit = static_cast<float>(unit);
    return media;
}

}  // namespace npr
