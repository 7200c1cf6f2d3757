// The lists of a band's pixels: goldfeather/lists/lists.h.
struct PixelList {
    uint count;  // surfaces along the pixel's ray
    uint next;   // where the next of them goes in `entries`
};
layout(std430, binding = 2) buffer PixelLists { PixelList pixel_lists[]; };
layout(std430, binding = 3) buffer Entries { uvec2 entries[]; };  // bits of the depth, triangle | kFromBehind
layout(std430, binding = 4) buffer Jobs { uvec2 jobs[]; };        // pixel, first entry; by class of length
layout(std430, binding = 5) buffer Status {
    uint entry_count;     // allocated
    uint longest;         // list
    uint most_layers;     // of any pixel, as far as asked for
    uint faults;          // pixels whose list was not filled to its end, or beyond
    uint class_sizes[3];  // jobs by class
    uint unfinished;      // jobs that are to be gone on with
    uint overlong;        // jobs that did more in one go than can be relied on
};

const uint kFromBehind = 0x80000000u;  // the surface is seen from inside its leaf

const uint kStateEntries = 2u;  // behind lists that are not of the shortest class: where the walk stands

uniform ivec2 band_size;  // width and rows of the band

uint pixel_index(ivec2 p) { return uint(p.y * band_size.x + p.x); }
