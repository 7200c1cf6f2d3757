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
    triangle = entries[list_first + cursor].y;
    leaf = triangles[triangle].leaf;
    ++cursor;
    return true;
}

void toggle(uint leaf) {
    uint at = 0u;
    while (at < inside_count && entries[inside_first + at].x != leaf)
        ++at;
    work += at + 1u;
    if (at < inside_count) {
        --inside_count;
        entries[inside_first + at] = entries[inside_first + inside_count];
    } else {
        entries[inside_first + inside_count] = uvec2(leaf, 0u);
        ++inside_count;
    }
}

void list_toggle_event() {
    uint leaf = 0u, triangle = 0u;
    for (uint cursor = list_event_begin(); list_event_next(cursor, leaf, triangle);)
        toggle(leaf);
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
        uint leaf = triangles[entries[list_first + i].y].leaf;
        if (blist_rows[2u * leaf + 1u].w != 0u)
            toggle(leaf);
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
