// The depth of a leaf's surface in this pixel, from its canonical plane.
#include "gl/view.glsl"

flat in vec4 plane_depth;
flat in vec2 depth_limits;

uniform float first_row;  // of this band of the picture, in pixels

float surface_depth() {
    vec2 at = vec2(gl_FragCoord.x, gl_FragCoord.y + first_row) - 0.5 * view.picture.xy;
    precise float depth = plane_depth.x * at.x + plane_depth.y * at.y + plane_depth.z;
    if (plane_depth.w > 0.5)
        depth = gl_FragCoord.z;
    // A sample that rasterization has moved over the triangle's border (by up to 1/256 pixel) must not be thrown far
    // along a steep plane. The slack keeps coplanar triangles on their common value everywhere else.
    float slack = min(0.02 * (abs(plane_depth.x) + abs(plane_depth.y)), 0.25 * (depth_limits.y - depth_limits.x)) +
                  1e-5 * depth_limits.y;
    depth = clamp(depth, depth_limits.x - slack, depth_limits.y + slack);
    return clamp(depth, 1e-30, 1.0);
}
