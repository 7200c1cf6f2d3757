#include "gl/view.glsl"
#include "layers/layer_stack.glsl"

// What every pass of a style knows (npr/frame_program.h). Colors are sRGB with straight alpha.
uniform int layer_count;
uniform vec3 centre_in_eye;  // eye coordinates of the origin of plane_rows
uniform vec2 jitter;  // of the sample from the pixel's centre, in pixels
uniform vec3 background_color;
uniform vec3 background_stop;
uniform vec3 face_color;
uniform vec3 cut_color;
uniform vec4 highlight_color;
uniform vec4 ghost_color;
uniform bool transparent_background;

ivec2 picture_size() {
    return textureSize(layer_depths, 0).xy;
}

bool in_picture(ivec2 pixel) {
    return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, picture_size()));
}

// Leaf and plane as the stack holds them; kNoSurface where the pixel, which must be in the picture, has no such layer.
uvec2 surface_ids(ivec2 pixel, int layer) {
    return layer < layer_count ? texelFetch(layer_surfaces, ivec3(pixel, layer), 0).xy : uvec2(kNoSurface);
}

#include "npr/pixel.glsl"
