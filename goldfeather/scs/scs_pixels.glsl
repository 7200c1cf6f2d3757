// One invocation a pixel of a rectangle of the band.
#include "goldfeather/scs/scs.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform ivec2 rectangle_first;
uniform ivec2 rectangle_size;

bool find_pixel(out ivec2 at) {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    at = rectangle_first + p;
    return all(lessThan(p, rectangle_size));
}
