// A tile of the picture as a quad, one instance each.
layout(location = 0) in uvec4 rectangle;  // x0, y0, x1, y1, in pixels of the picture
layout(location = 1) in uvec4 lists;      // first product, products, first leaf, leaves

uniform ivec2 band_size;
uniform float first_row;

flat out uvec4 tile_lists;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? rectangle.z : rectangle.x, (gl_VertexID & 2) != 0 ? rectangle.w : rectangle.y);
    corner.y -= first_row;
    gl_Position = vec4(2.0 * corner / vec2(band_size) - 1.0, 0.0, 1.0);
    tile_lists = lists;
}
