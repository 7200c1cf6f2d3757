#include "npr/part_style.h"

#include "npr/picture.h"

namespace npr {

bool names_part(std::string_view name, std::string_view part) {
    if (!part.starts_with(name)) {
        return false;
    }
    const std::string_view rest = part.substr(name.size());
    return rest.empty() ||
           (rest.size() > 1 && rest[0] == ' ' && rest.find_first_not_of("0123456789", 1) == std::string_view::npos);
}

bool selects(const PartSelector& selector, const layers::PartLook& part) {
    if (!selector.by_color && selector.exact) {
        return selector.name == part.name;
    }
    if (!selector.by_color) {
        return names_part(selector.name, part.name);
    }
    constexpr float kStep = 0.5F / 255;
    return part.color.r >= 0 &&
           glm::all(glm::lessThanEqual(glm::abs(glm::vec3(part.color) - selector.color), glm::vec3(kStep)));
}

std::vector<std::size_t> styles_of_parts(const Picture& picture, std::span<const layers::PartLook> parts) {
    std::vector<std::size_t> result(parts.size(), 0);
    for (std::size_t part = 0; part < parts.size(); ++part) {
        for (std::size_t i = 0; i < picture.part_styles.size(); ++i) {
            if (selects(picture.part_styles[i].of, parts[part])) {
                result[part] = i + 1;
            }
        }
    }
    return result;
}

}  // namespace npr
