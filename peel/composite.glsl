// What is seen of a pixel's layers, front to back (Porter and Duff 1984, "over"). Valid in shaders and, within a struct,
// in C++. All styles that see through layers walk them so:
//
//     Composite seen = nothing_seen();
//     while (goes_on(seen, layer_count, 0.0f)) {
//         Surface s = layer_surface(pixel, seen.layer, ray);
//         seen = behind(seen, s.hit, (its color, straight alpha));
//     }
struct Composite {
    vec3 color;     // premultiplied
    float through;  // light that comes through the layers so far
    int layer;      // the next one
    bool ended;     // the layer before it had no surface
};

Composite nothing_seen() {
    Composite c;
    c.color = vec3(0.0f);
    c.through = 1.0f;
    c.layer = 0;
    c.ended = false;
    return c;
}

// Is a further layer to be looked at? Behind the last surface comes one more, without a surface: there may still be the
// outer half of a line that bounds a neighbor's. `least`: light that must come through.
bool goes_on(Composite c, int layers, float least) {
    return c.layer < layers && !c.ended && c.through > least;
}

// The next layer, with straight alpha: all that is there, whether it is a surface (`hit`) or not.
Composite behind(Composite c, bool hit, vec4 color) {
    c.color += c.through * color.a * vec3(color);
    c.through *= 1.0f - color.a;
    c.ended = !hit;
    ++c.layer;
    return c;
}
