// What a line is and what hides it, where it is asked for (EdgeSettings::facts). Valid in shaders and, within a struct
// with the same names, in C++ (npr/edges/line_code.h).

// Kinds. A line that is several is the last of them: what ends a surface or parts two objects says more than a bend,
// and a bend more than a change of color.
const uint kColorBorder = 1u;   // of two colors of a part, where the surface does not bend
const uint kCrease = 2u;        // of two planes of a leaf
const uint kIntersection = 3u;  // of planes of two leaves of a part
const uint kPartBorder = 4u;    // of two parts that touch
const uint kSilhouette = 5u;    // the surface ends, before something farther away or nothing

struct LineFacts {
    uint kind;      // 0: no line
    int surfaces;   // all those before it
    int solids;     // that it is behind: how often the ray goes into opaque parts before it
    bool anchored;  // is `along` known?
    float along;    // in world units along the line in which two planes meet, from the point of it nearest to the
                    // world's origin: the same for a point of the model in every picture
};

LineFacts no_facts() {
    LineFacts f;
    f.kind = 0u;
    f.surfaces = 0;
    f.solids = 0;
    f.anchored = false;
    f.along = 0.0f;
    return f;
}

// Counts in that many bits; the largest number is that of all larger ones.
const int kMostSurfaces = 0x3fff;
const int kMostSolids = 0x1fff;

uvec2 pack_facts(LineFacts f) {
    uint counts = uint(min(f.surfaces, kMostSurfaces)) << 13 | uint(min(f.solids, kMostSolids));
    return uvec2(f.kind << 28 | (f.anchored ? 1u : 0u) << 27 | counts, floatBitsToUint(f.along));
}

LineFacts unpack_facts(uvec2 words) {
    LineFacts f;
    f.kind = words.x >> 28;
    f.anchored = (words.x >> 27 & 1u) != 0u;
    f.surfaces = int(words.x >> 13) & kMostSurfaces;
    f.solids = int(words.x) & kMostSolids;
    f.along = uintBitsToFloat(words.y);
    return f;
}
