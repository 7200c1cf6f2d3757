// Gives each pixel of a rectangle its place among the entries, by one atomic addition and no barrier, and sorts the
// pixels into classes by the lengths of their lists.
#include "goldfeather/lists/lists.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform ivec2 rectangle_first;
uniform ivec2 rectangle_size;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, rectangle_size)))
        return;
    uint pixel = pixel_index(rectangle_first + p);
    uint count = pixel_lists[pixel].count;
    if (count == 0u)
        return;
    uint list_class = count <= kShortest ? 0u : count <= kShort ? 1u : 2u;
    // A long list has as much room again behind it, for the leaves that hold the point.
    uint room = list_class == 0u ? count : list_class == 1u ? count + kStateEntries : 2u * count + kStateEntries;
    uint first = atomicAdd(entry_count, room);
    pixel_lists[pixel].next = first;
    uint job = atomicAdd(class_sizes[list_class], 1u);
    jobs[list_class * uint(rectangle_size.x * rectangle_size.y) + job] = uvec2(pixel, first);
    if (count > longest)
        atomicMax(longest, count);
}
