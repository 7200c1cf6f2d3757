#include "npr/edge_parameters.h"

#include <cmath>

namespace npr {

Parameter line_width(float initial) {
    return Parameter::number("width", "Width of lines", initial, 0.25F, 4);
}
Parameter crease_angle() {
    return Parameter::number("crease", "Angle of creases", 28, 0, 180);
}
Parameter part_edges() {
    return Parameter::toggle("parts", "Edges between parts", false);
}

void set_edges(const gl::Program& program, float crease_degrees, bool parts) {
    program.set("crease_cosine", std::cos(glm::radians(crease_degrees)));
    program.set("part_edges", parts);
}

}  // namespace npr
