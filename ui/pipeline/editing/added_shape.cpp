#include "ui/pipeline/editing/added_shape.h"

#include <cmath>

#include <fmt/format.h>

#include "ui/pipeline/editing/text_edit.h"

namespace ui {

double round_number(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value) + 1e-9)), of = value / power;
    return (of < 2 - 1e-9 ? 1 : of < 5 - 1e-9 ? 2 : 5) * power;
}

double round_number_above(double value) {
    const double below = round_number(value);
    return below >= value * (1 - 1e-9) ? below : round_number(2.5 * below);
}

std::string statement_of(AddedShape shape, double size, const glm::dvec3& at, bool hole) {
    const auto number = [&](double value) { return short_number(value, 1e-6 * size); };
    const std::string whole = number(size), half = number(size / 2);
    const char* const centered = hole ? ", center = true" : "";
    // Of the shape's own origin.
    glm::dvec3 origin = glm::round(at / (size / 10)) * (size / 10);
    std::string call;
    switch (shape) {
        case AddedShape::Cube:
            origin -= hole ? glm::dvec3(0) : glm::dvec3(size / 2, size / 2, 0);
            call = fmt::format("cube([{0}, {0}, {0}]{1})", whole, centered);
            break;
        case AddedShape::Sphere:
            origin.z += hole ? 0 : size / 2;
            call = fmt::format("sphere(d = {})", whole);
            break;
        case AddedShape::Cylinder:
            call = fmt::format("cylinder(h = {}, d = {}{})", whole, hole ? half : whole, centered);
            break;
        case AddedShape::Cone:
            call = fmt::format("cylinder(h = {0}, d1 = {0}, d2 = 0{1})", whole, centered);
            break;
        case AddedShape::Text:
            call = fmt::format("linear_extrude(height = {}{}) text(\"text\", size = {}, halign = \"center\")",
                               number(size / 5), centered, half);
            break;
        case AddedShape::Extrusion:
            origin -= glm::dvec3(size / 2, size / 2, 0);
            call = fmt::format("linear_extrude(height = {1}{2}) polygon([[0, 0], [{0}, 0], [{0}, {1}], [0, {0}]])",
                               whole, half, centered);
            break;
    }
    return fmt::format("translate([{}, {}, {}]) {};", number(origin.x), number(origin.y), number(origin.z), call);
}

}  // namespace ui
