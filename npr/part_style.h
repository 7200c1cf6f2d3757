// Styles of some parts of a picture.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "layers/surface_table.h"
#include "npr/parameter.h"

namespace npr {

struct StyleInfo;
struct Picture;

/// Parts by their name, or by the color of their material.
struct PartSelector {
    bool by_color = false;
    bool exact = false;  ///< That name alone, not those with a number behind it.
    std::string name;
    glm::vec3 color{0};  ///< sRGB.
    std::string text;    ///< As it was asked for: what messages call it.
    bool operator==(const PartSelector&) const = default;
};

/// Those parts are drawn in another style than the rest of the picture.
struct PartStyle {
    PartSelector of;
    const StyleInfo* style = nullptr;
    Parameters parameters;  ///< Of the style.
    float opacity = 1;      ///< Of all that the style draws.
    bool operator==(const PartStyle&) const = default;
};

/// What hides those parts is peeled away until such a share of them is to be seen (npr/reveal.h).
struct RevealedPart {
    PartSelector of;
    double fraction = 1;
    bool operator==(const RevealedPart&) const = default;
};

/// Whether `name` names the part: "bolt" does name the parts bolt, bolt 2, bolt 3, ….
[[nodiscard]] bool names_part(std::string_view name, std::string_view part);

[[nodiscard]] bool selects(const PartSelector& selector, const layers::PartLook& part);

/// By part: 0 where it is drawn in the picture's own style, else one more than the index of its PartStyle; of several
/// the last.
[[nodiscard]] std::vector<std::size_t> styles_of_parts(const Picture& picture, std::span<const layers::PartLook> parts);

}  // namespace npr
