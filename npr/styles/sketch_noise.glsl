// The noise of a sketch, the same for all samples and all layers of a picture. Valid in shaders and, within a struct
// with the same names, in C++.

const float kDome = 0.28f;  // its radius, of the diagonal of the scene

// Where the noise of a pixel is taken from: its place in the picture, in 512ths of the height, or on the plane through
// the scene: half of a ball about its middle that faces the eye, with a soft rim, flat outside. The model's surfaces move about as the dome does
// when it is turned, shifted or zoomed (6.7), and the noise is as smooth outside the model as within.
vec3 noise_place(ivec2 pixel) {
    vec2 at = vec2(pixel) + 0.5f - 0.5f * vec2(view.picture);
    if (!on_model)
        return vec3(at / unit, 0.0f);
    float scale = 2.0f * view.picture.z / view.picture.y;
    float distance = -center_in_eye.z;
    float radius = kDome * view.depth_range.w;
    vec2 aside = vec2(0.0f);
    float height = radius;
    for (int i = 0; i < 3; ++i) {
        aside = at * scale * (view.depth_range.z > 0.5f ? 1.0f : distance - height) - vec2(center_in_eye);
        float inside = 1.0f - dot(aside, aside) / (radius * radius);
        height = radius * sqrt(0.5f * (inside + sqrt(inside * inside + 0.02f)));
    }
    vec3 from_center = vec3(aside, height) * mat3(view.eye_from_world);
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
