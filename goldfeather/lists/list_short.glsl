// A pixel's list of at most kCapacity surfaces, in local arrays; the next event is selected, so that few layers of a
// long list cost little. Depths are compared by their bits, which for positive floats is the same.
uint list_depths[kCapacity];  // 0: none
uint list_leaves[kCapacity];
uint list_triangles[kCapacity];
uint list_backs;  // surfaces seen from behind
uint event_depth;
uint event_bits;   // surfaces of the event
uint inside_bits;  // one surface of each leaf that holds the point
uint list_state;   // the entry where the walk's state is kept

uint list_inside_begin() { return inside_bits; }
bool list_inside_next(inout uint cursor, out uint leaf) {
    ++work;
    leaf = list_leaves[cursor == 0u ? 0 : findLSB(cursor)];
    bool any = cursor != 0u;
    cursor &= cursor - 1u;
    return any;
}

uint list_event_begin() { return event_bits; }
bool list_event_next(inout uint cursor, out uint leaf, out uint triangle) {
    ++work;
    int i = cursor == 0u ? 0 : findLSB(cursor);
    leaf = list_leaves[i];
    triangle = list_triangles[i];
    bool any = cursor != 0u;
    cursor &= cursor - 1u;
    return any;
}

// How often the leaf is around the point before which all surfaces have at least this depth.
int winding(uint leaf, uint least_depth) {
    int passed = 0, all = 0;
    work += kCapacity;
    for (int i = 0; i < kCapacity; ++i) {
        if (list_depths[i] == 0u || list_leaves[i] != leaf)
            continue;
        int turn = (list_backs >> i & 1u) != 0u ? -1 : 1;
        all += turn;
        if (list_depths[i] >= least_depth)
            passed += turn;
    }
    return count_inside && is_behind(leaf) ? passed - all : passed;
}

void set_inside(int i, bool inside) {
    uint bit = 0u;
    for (uint bits = inside_bits; bits != 0u; bits &= bits - 1u) {
        ++work;
        int other = findLSB(bits);
        if (list_leaves[other] == list_leaves[i])
            bit = 1u << other;
    }
    if (!inside)
        inside_bits &= ~bit;
    else if (bit == 0u)
        inside_bits |= 1u << i;
}

void toggle(int i) {
    uint bit = 1u << i;
    for (uint bits = inside_bits; bits != 0u; bits &= bits - 1u) {
        ++work;
        int other = findLSB(bits);
        if (list_leaves[other] == list_leaves[i])
            bit = 1u << other;
    }
    inside_bits ^= bit;
}

// Passes the surfaces of the event, or goes back before them.
void list_pass_event(bool back) {
    for (uint bits = event_bits; bits != 0u; bits &= bits - 1u) {
        int i = findLSB(bits);
        if (is_wound(list_leaves[i]))
            set_inside(i, winding(list_leaves[i], back ? event_depth + 1u : event_depth) != 0);
        else
            toggle(i);
    }
}

// Does the event enter or leave the leaf? `odd`: the number of its surfaces there; `after`: they have been passed.
bool list_switches(uint leaf, bool odd, bool after) {
    if (!is_wound(leaf))
        return odd;
    return (winding(leaf, event_depth) != 0) != (winding(leaf, event_depth + 1u) != 0);
}

void list_load(uint first, uint count) {
    work = kCapacity;
    list_state = first + count;
    list_backs = 0u;
    for (uint i = 0u; i < uint(kCapacity); ++i) {
        uvec2 entry = i < count ? entries[first + i] : uvec2(0u);
        list_depths[i] = entry.x;
        list_triangles[i] = entry.y & ~kFromBehind;
        list_leaves[i] = triangles[list_triangles[i]].leaf;
        list_backs |= (entry.y & kFromBehind) != 0u ? 1u << i : 0u;
    }
    event_depth = 0xffffffffu;
    event_bits = 0u;
    inside_bits = 0u;
}

void list_begin(uint count) {
    if (!count_inside)
        return;
    for (int i = 0; i < int(count); ++i)
        if (is_wound(list_leaves[i])) {
            if (is_behind(list_leaves[i]))
                set_inside(i, winding(list_leaves[i], 0xffffffffu) != 0);
        } else if (is_behind(list_leaves[i])) {
            toggle(i);
        }
}

// Goes to the next event; false where there is none.
bool list_next_event() {
    work += 2u * kCapacity;
    uint next = 0u;
    for (int i = 0; i < kCapacity; ++i)
        if (list_depths[i] < event_depth)
            next = max(next, list_depths[i]);
    event_depth = next;
    event_bits = 0u;
    for (int i = 0; i < kCapacity; ++i)
        if (list_depths[i] == next)
            event_bits |= 1u << i;
    return next != 0u;
}

// Where the walk stands, in two words.
uvec2 list_position() { return uvec2(event_depth, inside_bits); }
void list_go_to(uvec2 position) {
    event_depth = position.x;
    inside_bits = position.y;
}
