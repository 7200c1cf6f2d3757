// A surface of a pixel, by its layer, continued to a neighbor. Valid in shaders; npr/painter/cpu_edges.cpp has its own.

Continuation continuation_at(ivec2 pixel, int layer, ivec2 offset) {
    return continuation(layer_surface(pixel, layer, pixel_ray(pixel)), pixel, offset);
}
