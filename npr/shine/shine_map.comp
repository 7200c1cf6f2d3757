// What shows through what, pixel by pixel, before distances are known.
#include "npr/frame.glsl"
#include "npr/color.glsl"
#include "npr/surface_color.glsl"
#include "npr/plane_lookup.glsl"
#include "npr/planes.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 17) writeonly buffer ShineSources { ShineSource shine_sources[]; };

#include "npr/shine/shine_rules.glsl"

uniform bool stop_at_back;

void main() {
    ivec2 size = picture_size();
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (p.x < size.x)
        shine_sources[p.y * size.x + p.x] = shine_source(p, stop_at_back);
}
