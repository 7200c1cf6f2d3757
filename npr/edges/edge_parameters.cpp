#include "npr/edges/edge_parameters.h"

#include "layers/limits.h"

namespace npr {

Parameter line_width(float initial) {
    return Parameter::length("width", "Width of lines", initial, 0.25F, 4);
}
Parameter inner_line_width() {
    return Parameter::number("inner-width", "Width of inner edges", 0.7F, 0, 1);
}
Parameter hidden_line_width() {
    return Parameter::number("hidden-width", "Width of hidden lines", 0.5F, 0, 1);
}
Parameter section_line_width() {
    return Parameter::number("section-width", "Width of edges of cuts", 1.5F, 0, 4);
}
Parameter line_halo() {
    return Parameter::length("halo", "Gap of lines behind others", 0, 0, 5);
}
Parameter line_taper() {
    return Parameter::number("taper", "Thinner the farther", 0, 0, 1);
}
Parameter line_taper_ends() {
    return Parameter::number("taper-ends", "Thinner toward their ends", 0, 0, 1);
}
Parameter crease_angle() {
    return Parameter::number("crease", "Angle of creases in meshes", EdgeSettings().crease_degrees, 0, 180);
}
Parameter part_edges() {
    return Parameter::toggle("parts", "Edges between parts and colors", EdgeSettings().parts);
}

Parameter first_layers() {
    return Parameter::integer("layers", "Layers (0: all)", layers::kAllLayers, 0, layers::kMostLayersOfControl);
}

}  // namespace npr
