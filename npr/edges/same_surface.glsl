// Valid in shaders and, within a struct with the same names, in C++.

// Are two surfaces of neighboring pixels one, by plane and look? Or no surface at all, both of them.
bool same_surface(uvec2 a, uvec2 b) {
    return (a.x == kNoSurface) == (b.x == kNoSurface) && (a.x == kNoSurface || a.y == b.y) &&
           !(part_edges && a.x != kNoSurface && !look_alike(leaf_of(a), leaf_of(b)));
}
