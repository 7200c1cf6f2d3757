// Lines along the edges of a bound edge map (npr/edges/edge_map.h).
#include "npr/edges/edge_point.glsl"
#include "npr/edges/line_ink.glsl"

layout(binding = 2) uniform usampler2D edge_marks;
layout(binding = 3) uniform usampler2D edge_tiles;
layout(binding = 4) uniform usampler2DArray edge_points;

// The layers with edges so near that lines of that width may cover `at`, and some more.
uint layers_near(vec2 at, float width) {
    ivec4 tiles = links_near(at, width) / kEdgeTile;
    uvec4 four = textureGather(edge_tiles, vec2(tiles.xy + 1) / vec2(textureSize(edge_tiles, 0)));
    uint marks = four.x | four.y | four.z | four.w;
    if (any(greaterThan(tiles.zw - tiles.xy, ivec2(1))))  // wide lines only
        for (int y = tiles.y; y <= tiles.w; ++y)
            for (int x = tiles.x; x <= tiles.z; ++x)
                marks |= texelFetch(edge_tiles, ivec2(x, y), 0).x;
    return (marks | marks >> kLayersApart) & ((1u << kLayersApart) - 1u);
}

#ifdef LINE_TYPES
#include "npr/edges/line_facts.glsl"
#include "npr/edges/line_types.glsl"

layout(binding = 8) uniform usampler2DArray edge_facts;
layout(std430, binding = 4) readonly buffer LineTypes { LineType line_types[]; };
uniform float line_unit;   // see pattern_ink
uniform float line_halo;   // see halo_ink
uniform float line_taper;  // see weight_by_distance
uniform float line_taper_ends;  // see weight_by_end

float weight_of(LineFacts facts) {
    return weight_by_distance(facts, line_taper) * weight_by_end(facts, line_halo, line_taper_ends);
}

// What is known of the line on a link; there must be one.
LineFacts facts_at(ivec2 lower, int layer, int axis) {
    ivec3 first = ivec3(lower, 2 * edge_slice(layer, axis));
    return unpack_facts(uvec2(texelFetch(edge_facts, first, 0).x, texelFetch(edge_facts, first + ivec3(0, 0, 1), 0).x));
}
#endif

// Ways to draw lines: whole, lighter about what is thin, or as OpenGL does.
const int kWhole = 0, kLight = 1, kHard = 2;

void add_piece(inout Edge edge, EdgePoint e, float ink, vec2 from_point, float width, bool hard) {
    float coverage = ink * (hard ? hard_piece(from_point, e.across, width) : piece(from_point, e.across, width));
    if (e.kind == kProfileEdge)
        edge.profile = max(edge.profile, coverage);
    else
        edge.inner = max(edge.inner, coverage);
}

// Lines of one layer: outlines `width` pixels wide, inner edges `inner`, not above it.
Edge edge_at(vec2 at, int layer, float width, float inner, int way) {
    ivec4 links = links_near(at, width);
    Edge edge = no_edge();
    for (int y = links.y; y <= links.w; ++y)
        for (int x = links.x; x <= links.z; ++x) {
            uint marks = texelFetch(edge_marks, ivec2(x, y), 0).x;
            for (int axis = 0; axis < 2; ++axis) {
                if ((marks & edge_mark(layer, axis)) == 0u)
                    continue;
                EdgePoint e = unpack_edge(texelFetch(edge_points, ivec3(x, y, edge_slice(layer, axis)), 0).x);
                float own = e.kind == kProfileEdge ? width : inner;
                float strength = 1.0;
#ifdef LINE_TYPES
                LineFacts facts = facts_at(ivec2(x, y), layer, axis);
                LineType type = line_types[type_of_line(facts)];
                own = type.width * width * weight_of(facts);
                strength = pattern_ink(type, facts, line_unit) * halo_ink(facts, line_halo);
                if (facts.kind == kSectionEdge)
                    e.kind = kProfileEdge;
#endif
                add_piece(edge, e, strength * (way == kLight ? thin_ink(e.thickness, own) : 1.0),
                          at - vec2(x, y) - e.at * vec2(1 - axis, axis), own, way == kHard);
            }
        }
    return edge;
}

Edge edge_at(vec2 at, int layer, float width) {
    return edge_at(at, layer, width, width, kWhole);
}

// How wide lines are drawn, and with how strong an ink, where only layers and kinds of edges tell them apart.
struct Pens {
    float width;  // of outlines in the first layer; the widest
    float inner_width;
    float hidden_width;  // of all in the other layers
    float profile_strength;
    float inner_strength;
};

// Of one line.
struct Pen {
    float width;
    float strength;
};

#ifdef LINE_TYPES
// By the line's type. `pens`: of all lines, by the style.
Pen pen_of(EdgePoint e, ivec2 lower, int layer, int axis, Pens pens) {
    LineFacts facts = facts_at(lower, layer, axis);
    LineType type = line_types[type_of_line(facts)];
    return Pen(type.width * pens.width * weight_of(facts),
               type.strength * pattern_ink(type, facts, line_unit) * halo_ink(facts, line_halo));
}
#else
// By layer and kind of edge.
Pen pen_of(EdgePoint e, ivec2 lower, int layer, int axis, Pens pens) {
    return Pen(layer > 0 ? pens.hidden_width : e.kind == kProfileEdge ? pens.width : pens.inner_width,
               e.kind == kProfileEdge ? pens.profile_strength : pens.inner_strength);
}
#endif

// Lines of all layers in one search: the ink of each.
void all_edges_at(vec2 at, Pens pens, out float ink[kLayersApart]) {
    for (int i = 0; i < kLayersApart; ++i)
        ink[i] = 0.0;
    ivec4 links = links_near(at, pens.width);
    for (int y = links.y; y <= links.w; ++y)
        for (int x = links.x; x <= links.z; ++x) {
            uint marks = texelFetch(edge_marks, ivec2(x, y), 0).x;
            while (marks != 0u) {
                int bit = findLSB(marks);
                marks &= marks - 1u;
                int axis = bit / kLayersApart, layer = bit % kLayersApart;
                EdgePoint e = unpack_edge(texelFetch(edge_points, ivec3(x, y, edge_slice(layer, axis)), 0).x);
                Pen pen = pen_of(e, ivec2(x, y), layer, axis, pens);
                vec2 from_point = at - vec2(x, y) - e.at * vec2(1 - axis, axis);
                float coverage = thin_ink(e.thickness, pen.width) * piece(from_point, e.across, pen.width);
                ink[layer] = max(ink[layer], pen.strength * coverage);
            }
        }
}

#ifdef OVERSHOOT
layout(binding = 5) uniform usampler2DArray overshoot_points;
layout(binding = 6) uniform usampler2D overshoot_tiles;

// Visible edges drawn on beyond their ends (npr/edges/overshoot.h).
Edge overshoot_at(vec2 at, float width) {
    Edge edge = no_edge();
    ivec4 links = links_near(at, width);
    ivec4 tiles = links / kEdgeTile;
    uint any = 0u;
    for (int y = tiles.y; y <= tiles.w; ++y)
        for (int x = tiles.x; x <= tiles.z; ++x)
            any |= texelFetch(overshoot_tiles, ivec2(x, y), 0).x;
    if (any == 0u)
        return edge;
    for (int y = links.y; y <= links.w; ++y)
        for (int x = links.x; x <= links.z; ++x)
            for (int axis = 0; axis < 2; ++axis) {
                uint bits = texelFetch(overshoot_points, ivec3(x, y, axis), 0).x;
                if (bits != 0u) {
                    EdgePoint e = unpack_edge(bits);
                    add_piece(edge, e, e.thickness, at - vec2(x, y) - e.at * vec2(1 - axis, axis), width, false);
                }
            }
    return edge;
}
#endif
