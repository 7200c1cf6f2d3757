// Boolean expressions as goldfeather/blist.h has them, evaluated over the leaves that hold the point only.
const uint kTrue = 0xfffffffeu, kFalse = 0xffffffffu;
const uint kNone = 0xffffffffu;

// Two rows a leaf: (inside, first, last, chain end), (group, complement, rank, flags);
// two rows a group: (start, last, when true, when false), (parent, operand, next); a row a part: (start, …).
layout(std430, binding = 6) readonly buffer BlistRows { uvec4 blist_rows[]; };

uniform uint first_group;  // rows before the groups, and
uniform uint first_start;  // before the parts

// The leaves that hold the point, from whoever includes this. `cursor` begins as list_inside_begin().
uint work;  // iterations of loops, about

// Flags of a leaf: inside is counted from behind; inside is where the winding number is not zero, not the parity odd
// (kWindings: is there any such leaf?).
bool is_behind(uint leaf) { return (blist_rows[2u * leaf + 1u].w & 1u) != 0u; }
bool is_wound(uint leaf) { return kWindings && (blist_rows[2u * leaf + 1u].w & 2u) != 0u; }

uint list_inside_begin();
bool list_inside_next(inout uint cursor, out uint leaf);

bool is_on_chain(uvec4 row, uint place) { return row.y <= place && place <= row.z; }

bool group_value(uvec4 group) {
    for (uint at = group.x;;) {
        uvec4 here = blist_rows[2u * at];
        uint next = kNone, leaf = 0u, next_inside = 0u;
        for (uint cursor = list_inside_begin(); list_inside_next(cursor, leaf);) {
            if (leaf >= at && leaf <= group.y && leaf < next) {
                uvec4 row = blist_rows[2u * leaf];
                if (is_on_chain(row, here.y)) {
                    next = leaf;
                    next_inside = row.x;
                }
            }
        }
        if (next == kNone) {
            uint nearer = min(group.z, group.w);
            if (nearer >= kTrue)
                return here.w == group.z;
            return is_on_chain(blist_rows[2u * nearer], here.y) == (nearer == group.z);
        }
        at = next_inside;
        if (at == group.z || at == group.w)
            return at == group.z;
    }
}

bool part_value(uint rank) {
    uint start = blist_rows[first_start + rank].x;
    return start >= kTrue ? start == kTrue : group_value(uvec4(start, kTrue - 1u, kTrue, kFalse));
}

bool holds(uint leaf) {
    uint other = 0u;
    for (uint cursor = list_inside_begin(); list_inside_next(cursor, other);)
        if (other == leaf)
            return true;
    return false;
}

// Is the leaf a literal of a product that is true here?
bool responsible(uint leaf) {
    uvec4 row = blist_rows[2u * leaf + 1u];
    if (blist_rows[2u * leaf].y == kNone || holds(leaf) == (row.y != 0u))
        return false;
    if (row.x == kNone)
        return true;
    if (!group_value(blist_rows[first_group + 2u * row.x]))
        return false;
    for (uvec4 inner = blist_rows[first_group + 2u * row.x + 1u]; inner.x != kNone;) {
        ++work;
        uvec4 outer = blist_rows[first_group + 2u * inner.x];
        if (inner.y != outer.x && !group_value(uvec4(outer.x, inner.y - 1u, inner.y, outer.w)))
            return false;
        if (inner.z != outer.z && !group_value(uvec4(inner.z, outer.yzw)))
            return false;
        inner = blist_rows[first_group + 2u * inner.x + 1u];
    }
    return true;
}
