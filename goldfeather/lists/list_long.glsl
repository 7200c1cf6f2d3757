// A pixel's list of any length, where it lies in memory: a heap with the nearest surface on top, so that few layers
// cost little and all of them n log n. Behind the list there is room for the leaves that hold the point.
uint list_first;
uint heap_size;
uint event_depth;
uint event_end;  // the surfaces of the event have been taken from the heap: they are from heap_size to here
uint inside_first;
uint inside_count;
uint list_state;  // the entry where the walk's state is kept

uint list_inside_begin() { return 0u; }
bool list_inside_next(inout uint cursor, out uint leaf) {
    ++work;
    leaf = 0u;
    if (cursor >= inside_count)
        return false;
    leaf = entries[inside_first + cursor].x;
    ++cursor;
    return true;
}

uint list_event_begin() { return heap_size; }
bool list_event_next(inout uint cursor, out uint leaf, out uint triangle) {
    ++work;
    leaf = 0u;
    triangle = 0u;
    if (cursor >= event_end)
        return false;
    triangle = entries[list_first + cursor].y & ~kFromBehind;
    leaf = triangles[triangle].leaf;
    ++cursor;
    return true;
}

// What passing a surface adds to a winding number, modulo 2^32.
uint turn(uint entry, bool back) { return ((entry & kFromBehind) != 0u) == back ? 1u : 0xffffffffu; }

// Behind each leaf that holds the point there is how often it does, where that is counted.
void toggle(uint leaf, uint by) {
    uint at = 0u;
    while (at < inside_count && entries[inside_first + at].x != leaf)
        ++at;
    work += at + 1u;
    if (at == inside_count) {
        entries[inside_first + inside_count] = uvec2(leaf, by);
        ++inside_count;
        return;
    }
    uint winding = is_wound(leaf) ? entries[inside_first + at].y + by : 0u;
    if (winding != 0u) {
        entries[inside_first + at].y = winding;
    } else {
        --inside_count;
        entries[inside_first + at] = entries[inside_first + inside_count];
    }
}

// Passes the surfaces of the event, or goes back before them.
void list_pass_event(bool back) {
    uint leaf = 0u, triangle = 0u;
    for (uint cursor = list_event_begin(); list_event_next(cursor, leaf, triangle);)
        toggle(leaf, turn(entries[list_first + cursor - 1u].y, back));
}

// Does the event enter or leave the leaf? `odd`: the number of its surfaces there; `after`: they have been passed.
bool list_switches(uint leaf, bool odd, bool after) {
    if (!is_wound(leaf))
        return odd;
    uint winding = 0u, by = 0u, other = 0u, triangle = 0u;
    for (uint at = 0u; at < inside_count; ++at)
        if (entries[inside_first + at].x == leaf)
            winding = entries[inside_first + at].y;
    for (uint cursor = list_event_begin(); list_event_next(cursor, other, triangle);)
        if (other == leaf)
            by += turn(entries[list_first + cursor - 1u].y, after);
    work += inside_count;
    return (winding != 0u) != (winding + by != 0u);
}

// Puts `entry` at `at` or below, in a heap of `size`.
void sift_down(uvec2 entry, uint at, uint size) {
    for (uint child = 2u * at + 1u; child < size; child = 2u * at + 1u) {
        ++work;
        uvec2 below = entries[list_first + child];
        if (child + 1u < size) {
            uvec2 other = entries[list_first + child + 1u];
            if (other.x > below.x) {
                below = other;
                ++child;
            }
        }
        if (below.x <= entry.x)
            break;
        entries[list_first + at] = below;
        at = child;
    }
    entries[list_first + at] = entry;
}

void list_load(uint first, uint count) {
    work = 0u;
    list_first = first;
    list_state = first + 2u * count;
    heap_size = count;
    event_end = count;
    event_depth = 0xffffffffu;
    inside_first = first + count;
    inside_count = 0u;
}

void list_begin(uint count) {
    work += count;
    for (uint i = count / 2u; i-- > 0u;)
        sift_down(entries[list_first + i], i, count);
    if (!count_inside)
        return;
    for (uint i = 0u; i < count; ++i) {
        uint entry = entries[list_first + i].y;
        uint leaf = triangles[entry & ~kFromBehind].leaf;
        if (is_behind(leaf))
            toggle(leaf, turn(entry, true));
    }
}

// Goes to the next event; false where there is none.
bool list_next_event() {
    event_end = heap_size;
    if (heap_size == 0u)
        return false;
    event_depth = entries[list_first].x;
    while (heap_size > 0u && entries[list_first].x == event_depth) {
        ++work;
        --heap_size;
        uvec2 nearest = entries[list_first], last = entries[list_first + heap_size];
        sift_down(last, 0u, heap_size);
        entries[list_first + heap_size] = nearest;
    }
    return true;
}

// Where the walk stands, in two words.
uvec2 list_position() { return uvec2(heap_size, inside_count); }
void list_go_to(uvec2 position) {
    heap_size = position.x;
    inside_count = position.y;
}
