// The noise of a sketch, the same for all samples and all layers of a picture. Valid in shaders and, within a struct
// with the same names, in C++.

#include "npr/styles/relief.glsl"

// Where the noise of a pixel is taken from: its place in the picture, in 512ths of the height, or, turned to the model's
// own axes, that on a smooth sheet over what the picture sees (6.7): so it moves as the surfaces do when the model is
// turned, shifted or zoomed, and goes on beyond the outlines.
vec3 noise_place(ivec2 pixel) {
    vec2 at = vec2(pixel) + 0.5f - 0.5f * vec2(view.picture);
    if (!on_model)
        return vec3(at / unit, 0.0f);
    float distance = relief_at(at - jitter);  // Its cells are of what the sample sees.
    vec2 aside = at * (2.0f * view.picture.z / view.picture.y) * (view.depth_range.z > 0.5f ? 1.0f : distance);
    vec3 from_center = (vec3(aside, -distance) - center_in_eye) * mat3(view.eye_from_world);
    return from_center * (400.0f / view.depth_range.w);
}

// One of the four values: long bows with a little tremor.
float stroke_noise(vec3 place, uint value) {
    uint s = seed * 8u + value;
    return 0.85f * perlin_noise(place / 130.0f + 0.37f, s) + 0.15f * perlin_noise(place / 37.0f + 0.71f, s + 4u);
}

// Offset (x, y) and two pressures, about -1 to 1.
vec4 sketch_noise(ivec2 pixel) {
    vec3 place = noise_place(pixel);
    vec2 offset = vec2(stroke_noise(place, 0u), stroke_noise(place, 1u));
    vec2 pressures = vec2(stroke_noise(place, 2u), stroke_noise(place, 3u));
    if (!correlated)
        offset = 0.5f * offset + 0.45f * (2.0f * vec2(white_noise(pixel - guard, seed)) - 1.0f);
    return vec4(offset, pressures);
}
