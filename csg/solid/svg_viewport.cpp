#include "csg/solid/svg_viewport.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "csg/solid/file_text.h"
#include "csg/solid/svg_path.h"

namespace csg::solid {
namespace {

constexpr double kInch = 25.4;  // Millimeters.

/// User units in one of the unit named; 0 for a percentage.
double user_units(std::string_view name, double dots_per_inch) {
    if (name == "mm") {
        return dots_per_inch / kInch;
    }
    if (name == "cm") {
        return 10 * dots_per_inch / kInch;
    }
    if (name == "in") {
        return dots_per_inch;
    }
    if (name == "pt") {
        return dots_per_inch / 72;
    }
    if (name == "pc") {
        return dots_per_inch / 6;
    }
    return name == "%" ? 0 : 1;
}

struct Length {
    std::optional<double> number;
    std::string_view unit;
};

Length split(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    text.remove_prefix(begin);
    const std::size_t end = std::min(text.find_first_not_of("0123456789.+-eE"), text.size());
    std::string_view digits = text.substr(0, end), unit = text.substr(end);
    // The e of "em" belongs to no number.
    while (!digits.empty() && (digits.back() == 'e' || digits.back() == 'E')) {
        digits.remove_suffix(1);
        unit = text.substr(digits.size());
    }
    return {to_number(digits), unit.substr(0, unit.find_last_not_of(" \t\r\n") + 1)};
}

/// Millimeters of a side of the page, as OpenSCAD takes them; `view`: the side of the viewBox, 0 where there is none.
double page_side(std::string_view text, double view, double dots_per_inch) {
    const auto [number, unit] = split(text);
    if (!number || unit == "%") {
        return number.value_or(100) / 100 * view * kInch / dots_per_inch;
    }
    if (unit == "em" || unit == "ex") {
        return view;
    }
    constexpr double kDotsPerInch = 96;  // Of CSS.
    return *number * (unit == "px" ? kInch / kDotsPerInch : user_units(unit, dots_per_inch) * kInch / dots_per_inch);
}

/// x, y, width, height; empty where it is none.
std::vector<double> view_box(const SvgElement& element) {
    std::vector<double> box = read_svg_numbers(attribute(element.attributes, "viewBox"));
    if (box.size() != 4 || !(box[2] > 0) || !(box[3] > 0)) {
        box.clear();
    }
    return box;
}

/// Where in the room that is left: 0, a half or 1.
double part_of(std::string_view align, std::string_view axis) {
    const std::size_t at = align.find(axis);
    const std::string_view word = at == std::string_view::npos ? "Mid" : align.substr(at + 1, 3);
    return word == "Min" ? 0 : word == "Max" ? 1 : 0.5;
}

struct Fit {
    glm::dvec2 scale, room;  ///< Room beside it at the lower end of each axis.
};

/// Of a viewBox of size `view` into a rectangle, by the element's preserveAspectRatio.
Fit fit(const SvgElement& element, const glm::dvec2& size, const glm::dvec2& view) {
    const std::string_view align = attribute(element.attributes, "preserveAspectRatio");
    Fit result{size / view, glm::dvec2(0.0)};
    if (align.find("none") == std::string_view::npos) {
        const bool slice = align.find("slice") != std::string_view::npos;
        result.scale =
            glm::dvec2(slice ? std::max(result.scale.x, result.scale.y) : std::min(result.scale.x, result.scale.y));
        result.room = (size - result.scale * view) * glm::dvec2(part_of(align, "xM"), part_of(align, "YM"));
    }
    return result;
}

}  // namespace

double svg_length(std::string_view text, double dots_per_inch, double whole) {
    const auto [number, unit] = split(text);
    return unit == "%" ? number.value_or(0) / 100 * whole : number.value_or(0) * user_units(unit, dots_per_inch);
}

glm::dvec2 svg_view_size(const SvgElement& element) {
    const std::vector<double> box = view_box(element);
    return box.empty() ? glm::dvec2(0.0) : glm::dvec2(box[2], box[3]);
}

glm::dmat4 svg_fit(const SvgElement& element, const glm::dvec2& size) {
    glm::dmat4 m(1.0);
    const std::vector<double> box = view_box(element);
    if (box.empty() || !(size.x > 0) || !(size.y > 0)) {
        return m;
    }
    const glm::dvec2 corner(box[0], box[1]);
    const auto [scale, room] = fit(element, size, {box[2], box[3]});
    m[0][0] = scale.x;
    m[1][1] = scale.y;
    m[3] = glm::dvec4(room - scale * corner, 0, 1);
    return m;
}

glm::dmat4 svg_page(const SvgElement& root, double dots_per_inch) {
    const std::vector<double> box = view_box(root);
    const glm::dvec2 view = svg_view_size(root);
    const std::string_view width = attribute(root.attributes, "width"), height = attribute(root.attributes, "height");
    const glm::dvec2 page(page_side(width, view.x, dots_per_inch), page_side(height, view.y, dots_per_inch));
    glm::dmat4 m(1.0);
    if (box.empty()) {
        m[1][1] = -1;
        m[3][1] = page.y;
        return m;
    }
    const auto [scale, room] = fit(root, page, view);
    // The corner counts by the page's share of the viewBox, and up where it should count down.
    const auto share = [](std::string_view text) {
        const auto [number, unit] = split(text);
        return unit == "%" ? number.value_or(0) / 100 : 1.0;
    };
    m[0][0] = scale.x;
    m[1][1] = -scale.y;
    m[3][0] = room.x - scale.x * share(width) * box[0];
    m[3][1] = page.y - room.y - scale.y * share(height) * box[1];
    return m;
}

}  // namespace csg::solid
