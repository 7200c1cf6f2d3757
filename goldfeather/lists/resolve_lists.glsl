// Walks along a pixel's ray, event by event, and stores a layer where the value of a part changes. Before this:
// kCapacity, the list (list_short.glsl, list_long.glsl) and what these need.

#include "layers/surface_ids.glsl"

layout(local_size_x = 64) in;

const uint kFinished = 0xffffffffu;

layout(r32f, binding = 0) writeonly uniform image2DArray layer_depths;
layout(rg32ui, binding = 1) writeonly uniform uimage2DArray layer_surfaces;

uniform uint first_job;
uniform uint job_count;
uniform uint part_count;
uniform int first_row;        // of the band in the picture
uniform uint layer_limit;     // wanted
uniform uint layer_capacity;  // allocated

// Some drivers end loops without a word after so many iterations, counted over the whole shader. Lists with more work
// are resolved in several goes, from event to event.
uniform bool going_on;     // with what an earlier go has left
uniform uint pause_after;  // loop iterations, or
uniform uint most_work;    // that are relied on

// The smallest rank of a part that has a surface at the event and is not before `from`.
uint event_rank(uint from) {
    if (part_count == 1u)
        return from == 0u ? 0u : kNone;
    uint rank = kNone, leaf = 0u, triangle = 0u;
    for (uint cursor = list_event_begin(); list_event_next(cursor, leaf, triangle);) {
        uint of_leaf = blist_rows[2u * leaf + 1u].z;
        if (of_leaf >= from)
            rank = min(rank, of_leaf);
    }
    return rank;
}

// The smallest leaf of the part that switches and is responsible on the side where the leaves inside are those of now,
// which is after or before the event, as the stack holds it.
uint find_leaf(uint rank, bool after) {
    uint leaf = 0u, triangle = 0u;
    for (uint from = 0u;;) {
        uint smallest = kNone;
        bool odd = false;
        for (uint cursor = list_event_begin(); list_event_next(cursor, leaf, triangle);) {
            if (leaf == smallest) {
                odd = !odd;
            } else if (leaf >= from && leaf < smallest && blist_rows[2u * leaf + 1u].z == rank) {
                smallest = leaf;
                odd = true;
            }
        }
        if (smallest == kNone)
            return kNoSurface;  // not reached: the value has changed
        if (list_switches(smallest, odd, after) && responsible(smallest))
            return leaf_word(smallest, !holds(smallest));
        from = smallest + 1u;
    }
}

uint smallest_plane() {
    uint plane = kNone, leaf = 0u, triangle = 0u;
    for (uint cursor = list_event_begin(); list_event_next(cursor, leaf, triangle);)
        plane = min(plane, triangles[triangle].plane);
    return plane;
}

void store(ivec2 at, uint layer, uint rank, bool leaving) {
    if (layer >= layer_capacity)
        return;
    // The result's side of the event is before it where the ray leaves.
    if (leaving)
        list_pass_event(true);
    uint id = find_leaf(rank, !leaving);
    if (leaving)
        list_pass_event(false);
    imageStore(layer_depths, ivec3(at, layer), vec4(uintBitsToFloat(event_depth)));
    imageStore(layer_surfaces, ivec3(at, layer), uvec4(id, plane_word(smallest_plane(), leaving), 0u, 0u));
}

void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationIndex;
    if (i >= job_count)
        return;
    uvec2 job = jobs[first_job + i];
    uint count = pixel_lists[job.x].count;
    if (pixel_lists[job.x].next != job.y + count) {
        atomicAdd(faults, 1u);
        return;
    }
    ivec2 at = ivec2(int(job.x) % band_size.x, int(job.x) / band_size.x + first_row);
    list_load(job.y, count);
    uint found = 0u;
    uint known_rank = kNone;  // of the part whose value is known
    bool known = false;
    if (!going_on) {
        list_begin(count);
    } else {
        uvec2 state = entries[list_state + 1u];
        if (state.x == kFinished)
            return;
        found = state.x;
        known_rank = state.y >> 1;
        known = (state.y & 1u) != 0u;
        list_go_to(entries[list_state]);
    }
    bool paused = false;
    while (!paused && found < layer_limit && list_next_event()) {
        for (uint rank = event_rank(0u); rank != kNone;) {
            bool before = rank == known_rank ? known : part_value(rank);
            list_pass_event(false);
            known = part_value(rank);
            known_rank = rank;
            if (before != known && found < layer_limit)
                store(at, found++, rank, before);
            rank = event_rank(rank + 1u);
            if (rank != kNone)
                list_pass_event(true);  // Each part sees the event from before it.
        }
        paused = kPauses && work > pause_after;
    }
    if (work > most_work)
        atomicAdd(overlong, 1u);
    if (kPauses) {
        entries[list_state] = list_position();
        entries[list_state + 1u] = uvec2(paused ? found : kFinished, known_rank << 1 | (known ? 1u : 0u));
        if (paused) {
            atomicAdd(unfinished, 1u);
            return;
        }
    }
    if (found > most_layers)
        atomicMax(most_layers, found);
}
