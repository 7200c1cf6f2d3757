#include "csg/solid/svg_viewport.h"

#include <algorithm>
#include <vector>

#include "csg/solid/file_text.h"
#include "csg/solid/svg_path.h"

namespace csg::solid {
namespace {

constexpr double kInch = 25.4;  // Millimetres.

/// User units in one of the unit named; 0 for a percentage.
double user_units(std::string_view name, double dots_per_inch) {
    if (name == "mm")
        return dots_per_inch / kInch;
    if (name == "cm")
        return 10 * dots_per_inch / kInch;
    if (name == "in")
        return dots_per_inch;
    if (name == "pt")
        return dots_per_inch / 72;
    if (name == "pc")
        return dots_per_inch / 6;
    return name == "%" ? 0 : 1;
}

/// x, y, width, height; empty where it is none.
std::vector<double> view_box(const SvgElement& element) {
    std::vector<double> box = read_svg_numbers(attribute(element.attributes, "viewBox"));
    if (box.size() != 4 || !(box[2] > 0) || !(box[3] > 0))
        box.clear();
    return box;
}

/// Where in the room that is left: 0, a half or 1.
double part_of(std::string_view align, std::string_view axis) {
    const std::size_t at = align.find(axis);
    const std::string_view word = at == std::string_view::npos ? "Mid" : align.substr(at + 1, 3);
    return word == "Min" ? 0 : word == "Max" ? 1 : 0.5;
}

}  // namespace

double svg_length(std::string_view text, double dots_per_inch, double whole) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    text.remove_prefix(begin);
    const std::size_t end = std::min(text.find_first_not_of("0123456789.+-eE"), text.size());
    std::string_view digits = text.substr(0, end), unit = text.substr(end);
    // The e of "em" belongs to no number.
    while (!digits.empty() && (digits.back() == 'e' || digits.back() == 'E'))
        digits.remove_suffix(1);
    const double number = to_number(digits).value_or(0);
    unit = unit.substr(0, unit.find_last_not_of(" \t\r\n") + 1);
    return unit == "%" ? number / 100 * whole : number * user_units(unit, dots_per_inch);
}

glm::dvec2 svg_view_size(const SvgElement& element) {
    const std::vector<double> box = view_box(element);
    return box.empty() ? glm::dvec2(0.0) : glm::dvec2(box[2], box[3]);
}

glm::dmat4 svg_fit(const SvgElement& element, const glm::dvec2& size) {
    glm::dmat4 m(1.0);
    const std::vector<double> box = view_box(element);
    if (box.empty() || !(size.x > 0) || !(size.y > 0))
        return m;
    const std::string_view align = attribute(element.attributes, "preserveAspectRatio");
    const glm::dvec2 corner(box[0], box[1]), view(box[2], box[3]);
    glm::dvec2 scale = size / view;
    glm::dvec2 room(0.0);
    if (align.find("none") == std::string_view::npos) {
        const bool slice = align.find("slice") != std::string_view::npos;
        scale = glm::dvec2(slice ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y));
        room = (size - scale * view) * glm::dvec2(part_of(align, "xM"), part_of(align, "YM"));
    }
    m[0][0] = scale.x;
    m[1][1] = scale.y;
    m[3] = glm::dvec4(room - scale * corner, 0, 1);
    return m;
}

glm::dmat4 svg_page(const SvgElement& root, double dots_per_inch) {
    const double pixel = kInch / dots_per_inch;
    const glm::dvec2 view = svg_view_size(root);
    const auto side = [&](std::string_view name, double of_view) {
        const std::string_view text = attribute(root.attributes, name);
        return text.empty() ? 0 : svg_length(text, dots_per_inch, of_view);
    };
    glm::dvec2 size(side("width", view.x), side("height", view.y));
    // A side that is not given follows the other one, or is the viewBox's own.
    if (view.x > 0) {
        const glm::dvec2 given = size;
        if (!(given.x > 0))
            size.x = given.y > 0 ? given.y * view.x / view.y : view.x;
        if (!(given.y > 0))
            size.y = given.x > 0 ? given.x * view.y / view.x : view.y;
    }
    glm::dmat4 up(1.0);
    up[0][0] = pixel;
    up[1][1] = -pixel;
    up[3][1] = size.y * pixel;
    return up * svg_fit(root, size);
}

}  // namespace csg::solid
