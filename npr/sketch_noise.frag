// The noise of a sketch, the same for all samples and all layers of a picture.
#include "npr/frame.glsl"
#include "npr/noise.glsl"

uniform uint seed;
uniform float unit;       // pixels in a 512th of the picture's height
uniform bool on_model;    // anchored to the model, else to the picture
uniform bool correlated;  // Perlin noise, else every pixel has its own (chalk)
out vec4 result;          // offset (x, y) and two pressures, about -1 to 1

// The model's anchor: its place on the plane through the middle of the scene that faces the eye. Moving and zooming
// take the noise along, turning lets it change slowly, and it is as smooth outside the model as within.
vec3 place() {
    vec2 at = gl_FragCoord.xy - 0.5 * view.picture.xy;
    if (!on_model)
        return vec3(at / unit, 0.0);
    float scale = 2.0 * view.picture.z / view.picture.y;
    float distance = -centre_in_eye.z;
    vec2 in_eye = at * scale * (view.depth_range.z > 0.5 ? 1.0 : distance);
    vec3 from_centre = vec3(in_eye - centre_in_eye.xy, 0.0) * mat3(view.eye_from_world);
    return from_centre * (400.0 / view.depth_range.w);
}

void main() {
    vec3 p = place();
    vec4 n;
    for (uint i = 0u; i < 4u; ++i) {
        uint s = seed * 8u + i;
        // Long bows with a little tremor.
        n[i] = 0.85 * perlin_noise(p / 130.0 + 0.37, s) + 0.15 * perlin_noise(p / 37.0 + 0.71, s + 4u);
    }
    if (!correlated) {
        vec3 own = white_noise(ivec2(gl_FragCoord.xy), seed);
        n.xy = 0.5 * n.xy + 0.45 * (2.0 * own.xy - 1.0);
    }
    result = n;
}
