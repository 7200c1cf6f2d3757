// Draws straight visible edges on beyond their ends, as a hand does.
#include "npr/frame.glsl"
#include "npr/lines.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 2) readonly buffer Links {
    uint link_count;
    uint links[];
};
layout(r32ui, binding = 0) uniform uimage2DArray overshoot_points;
layout(r32ui, binding = 1) uniform uimage2D overshoot_tiles;

uniform float overshoot;  // pixels

bool in_line(EdgePoint e, ivec2 lower, vec2 along, vec2 at, vec2 across) {
    vec2 apart = vec2(lower) + e.at * along - at;
    return abs(dot(e.across, across)) > 0.985 && abs(dot(apart, across)) < 0.75 && dot(apart, apart) < 1.6;
}

// Is there a visible edge at this place, in this direction?
bool line_at(vec2 at, vec2 across) {
    ivec4 window = links_near(at, 1.0);
    for (int y = window.y; y <= window.w; ++y)
        for (int x = window.x; x <= window.z; ++x) {
            ivec2 p = ivec2(x, y);
            uint marks = texelFetch(edge_marks, p, 0).x;
            for (int axis = 0; axis < 2; ++axis)
                if ((marks & edge_mark(0, axis)) != 0u &&
                    in_line(unpack_edge(texelFetch(edge_points, ivec3(p, axis), 0).x), p, vec2(1 - axis, axis), at,
                            across))
                    return true;
        }
    return false;
}

// How far the edge goes back in a straight line, about; 0 where it does not end here.
float straight_length(EdgePoint e, vec2 from, vec2 direction) {
    if (line_at(from + 2.0 * direction, e.across) || line_at(from + 3.5 * direction, e.across))
        return 0.0;
    float behind = 4.0;
    while (behind <= 2.5 * overshoot && line_at(from - behind * direction, e.across))
        behind += 4.0;
    return behind - 4.0;
}

void draw_on(EdgePoint e, vec2 from, vec2 direction, float reach) {
    bool steep = abs(direction.y) > abs(direction.x);
    vec2 step = direction / (steep ? abs(direction.y) : abs(direction.x));
    // The points in which the line crosses the rows or columns of samples.
    float first = steep ? from.y : from.x;
    float skip = steep ? (direction.y > 0.0 ? ceil(first) - first : first - floor(first))
                       : (direction.x > 0.0 ? ceil(first) - first : first - floor(first));
    vec2 at = from + skip * step;
    int axis = steep ? 0 : 1;
    ivec2 last = textureSize(edge_marks, 0) - 2;
    for (float way = 0.0; way < reach; way += length(step), at += step) {
        ivec2 lower = ivec2(steep ? floor(at.x) : round(at.x), steep ? round(at.y) : floor(at.y));
        if (any(lessThan(lower, ivec2(0))) || any(greaterThan(lower, last)))
            return;
        e.at = steep ? at.x - float(lower.x) : at.y - float(lower.y);
        e.strength = 1.0 - 0.85 * way / reach;
        imageAtomicMax(overshoot_points, ivec3(lower, axis), pack_edge(e));
        imageAtomicOr(overshoot_tiles, lower / kEdgeTile, 1u);
    }
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= link_count)
        return;
    int axis = link_axis(links[i]);
    ivec2 lower = link_lower(links[i], textureSize(edge_marks, 0).x);
    if ((texelFetch(edge_marks, lower, 0).x & edge_mark(0, axis)) == 0u)
        return;
    EdgePoint e = unpack_edge(texelFetch(edge_points, ivec3(lower, axis), 0).x);
    vec2 from = vec2(lower) + e.at * vec2(1 - axis, axis);
    for (float turn = -1.0; turn < 2.0; turn += 2.0) {
        vec2 direction = turn * vec2(-e.across.y, e.across.x);
        // Short edges are not drawn on as far as long ones, and bows not at all.
        float straight = straight_length(e, from, direction);
        if (straight > 10.0)
            draw_on(e, from, direction, min(overshoot, 0.35 * straight));
    }
}
