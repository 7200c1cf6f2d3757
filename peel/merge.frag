// Merges two stacks, each sorted by depth, into one. At equal depth `front` comes first.
#include "layers/surface_ids.glsl"

layout(binding = 0) uniform sampler2DArray front_depths;
layout(binding = 1) uniform usampler2DArray front_surfaces;
layout(binding = 2) uniform sampler2DArray back_depths;
layout(binding = 3) uniform usampler2DArray back_surfaces;
layout(r32f, binding = 0) writeonly uniform image2DArray depths;
layout(rg32ui, binding = 1) writeonly uniform uimage2DArray surfaces;

uniform int front_layers;
uniform int back_layers;
uniform int layers;

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    int f = 0, b = 0;
    for (int i = 0; i < layers; ++i) {
        float front = f < front_layers ? texelFetch(front_depths, ivec3(p, f), 0).x : 0.0;
        float back = b < back_layers ? texelFetch(back_depths, ivec3(p, b), 0).x : 0.0;
        float depth = max(front, back);  // reversed: the larger is nearer
        uvec4 surface = uvec4(kNoSurface, 0u, 0u, 0u);
        if (depth > 0.0)
            surface = front >= back ? texelFetch(front_surfaces, ivec3(p, f++), 0)
                                    : texelFetch(back_surfaces, ivec3(p, b++), 0);
        imageStore(depths, ivec3(p, i), vec4(depth));
        imageStore(surfaces, ivec3(p, i), surface);
    }
    discard;
}
