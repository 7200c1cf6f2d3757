// Between two geometry passes: applies the toggles of the event, evaluates the sum of products before and after it, and
// stores a layer where the value changes.
#include "goldfeather/goldfeather/walk.glsl"
#include "layers/surface_ids.glsl"

flat in uvec4 tile_lists;

struct ProductRow {
    uvec4 rectangle;  // x0, y0, x1, y1
    uvec4 entries;    // first, count
};
struct LeafSlot {
    uvec4 rectangle;
    uvec4 leaf;       // id, slot
};
layout(std430, binding = 5) readonly buffer Products { ProductRow products[]; };
layout(std430, binding = 6) readonly buffer Entries { uvec4 entries[]; };  // word, bits to be set, bits to be clear
layout(std430, binding = 7) readonly buffer TileProducts { uint tile_products[]; };
layout(std430, binding = 9) readonly buffer TileLeaves { LeafSlot tile_leaves[]; };

layout(binding = 10) uniform sampler2D next_depth;
layout(r32f, binding = 0) writeonly uniform image2DArray layer_depths;
layout(rg32ui, binding = 1) writeonly uniform uimage2DArray layer_surfaces;

uniform bool starting;
uniform bool count_inside;
uniform float first_row;
uniform uint words;
uniform uint layer_limit;     // wanted; a pixel with as many is done
uniform uint layer_capacity;  // allocated

bool holds(uvec4 rectangle, uvec2 p) {
    return all(greaterThanEqual(p, rectangle.xy)) && all(lessThan(p, rectangle.zw));
}

// A word after the event.
uint word_after(uint word, uint bits, uint toggled) { return is_counter(word) ? bits + toggled : bits ^ toggled; }

// The slots whose leaf holds the point: for a word that is a winding number, all of them or none.
uint slots_inside(uint word, uint bits) { return !is_counter(word) ? bits : bits != 0u ? 0xffffffffu : 0u; }

// Is the product true just before (`before`) or just after the event? The toggles are still to be applied to
// inside_bits.
bool product_value(uint product, uint pixel, bool before) {
    uvec2 range = products[product].entries.xy;
    for (uint i = range.x; i < range.x + range.y; ++i) {
        uvec4 e = entries[i];
        uint at = word_index(e.x, pixel);
        uint bits = inside_bits[at];
        if (!before && !starting)
            bits = word_after(e.x, bits, toggled_bits[at]);
        bits = slots_inside(e.x, bits);
        if ((bits & e.y) != e.y || (bits & e.z) != 0u)
            return false;
    }
    return true;
}

bool sum_after(uint pixel, uvec2 at) {
    for (uint i = 0u; i < tile_lists.y; ++i) {
        uint product = tile_products[tile_lists.x + i];
        if (holds(products[product].rectangle, at) && product_value(product, pixel, false))
            return true;
    }
    return false;
}

// Does some product that holds a literal of this slot have the value 1 on the result's side of the event?
bool responsible(uint slot, uint pixel, uvec2 at, bool before) {
    for (uint i = 0u; i < tile_lists.y; ++i) {
        uint product = tile_products[tile_lists.x + i];
        if (!holds(products[product].rectangle, at))
            continue;
        uvec2 range = products[product].entries.xy;
        bool member = false;
        for (uint j = range.x; j < range.x + range.y; ++j)
            member = member || (entries[j].x == slot >> 5 && ((entries[j].y | entries[j].z) >> (slot & 31u) & 1u) != 0u);
        if (member && product_value(product, pixel, before))
            return true;
    }
    return false;
}

// The smallest leaf that the event is due to, as the stack holds it.
uint find_leaf(uint pixel, uvec2 at, bool entering) {
    for (uint i = 0u; i < tile_lists.w; ++i) {
        LeafSlot row = tile_leaves[tile_lists.z + i];
        uint slot = row.leaf.y;
        uint word = slot >> 5, index = word_index(word, pixel);
        if (!holds(row.rectangle, at) || toggled_bits[index] == 0u)
            continue;
        uint before = slots_inside(word, inside_bits[index]);
        uint after = slots_inside(word, word_after(word, inside_bits[index], toggled_bits[index]));
        if (((before ^ after) >> (slot & 31u) & 1u) == 0u)
            continue;
        if (responsible(slot, pixel, at, !entering)) {
            bool inside_after = (after >> (slot & 31u) & 1u) != 0u;
            return leaf_word(row.leaf.x, inside_after != entering);
        }
    }
    return kNoSurface;  // not reached: the sum has changed
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    uvec2 at = uvec2(p.x, p.y + int(first_row));
    uint pixel = pixel_index(p);
    float current = starting ? 1.0 : pixels[pixel].current;
    bool full = false;
    if (current > 0.0) {
        float next = texelFetch(next_depth, p, 0).x;
        uint found = starting ? 0u : pixels[pixel].found;
        if (starting) {
            if (count_inside && sum_after(pixel, at))
                found = 1u;
        } else {
            bool inside = (found & 1u) != 0u;
            if (sum_after(pixel, at) != inside) {
                uint layer = found >> 1;
                if (layer < layer_capacity) {
                    uint id = find_leaf(pixel, at, !inside);
                    imageStore(layer_depths, ivec3(at, layer), vec4(current));
                    imageStore(layer_surfaces, ivec3(at, layer),
                               uvec4(id, plane_word(pixels[pixel].plane, inside), 0u, 0u));
                }
                found = ((layer + 1u) << 1) | (inside ? 0u : 1u);
                full = layer + 1u == layer_capacity;
                if (layer + 1u == layer_limit)
                    next = 0.0;
            }
            for (uint word = 0u; word < words; ++word) {
                uint bits = word_index(word, pixel);
                uint toggled = toggled_bits[bits];
                if (toggled != 0u) {
                    inside_bits[bits] = word_after(word, inside_bits[bits], toggled);
                    toggled_bits[bits] = 0u;
                }
            }
        }
        pixels[pixel].current = next;
        pixels[pixel].found = found;
        pixels[pixel].plane = 0xffffffffu;
    }
    // A query counts the pixels that have filled the last layer allocated.
    if (!full)
        discard;
}
