// How a stack of layers holds surfaces: two words, one for the leaf and one for the plane. Valid in shaders and, within
// a struct, in C++ (layers/surface.h).

const uint kNoSurface = 0xffffffffu;  // in place of the leaf's word: the pixel has no more layers

// `reversed`: the leaf is a subtracted one, and the surface a cut.
uint leaf_word(uint leaf, bool reversed) {
    return leaf << 1 | (reversed ? 1u : 0u);
}

// `leaving`: the ray leaves the result there, a back face of it.
uint plane_word(uint plane, bool leaving) {
    return plane << 1 | (leaving ? 1u : 0u);
}

uint leaf_of(uvec2 ids) {
    return ids.x >> 1;
}

bool is_reversed(uvec2 ids) {
    return (ids.x & 1u) != 0u;
}

uint plane_of(uvec2 ids) {
    return ids.y >> 1;
}

bool is_leaving(uvec2 ids) {
    return (ids.y & 1u) != 0u;
}
