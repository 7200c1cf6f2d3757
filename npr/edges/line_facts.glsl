// What a line is and what hides it, where it is asked for (EdgeSettings::facts). Valid in shaders and, within a struct
// with the same names, in C++ (npr/edges/line_code.h).

// Kinds. A line that is several is the last of them: what ends a surface or parts two objects says more than a bend,
// and a bend more than a change of color.
const uint kColorBorder = 1u;   // of two colors of a part, where the surface does not bend
const uint kCrease = 2u;        // of two planes of a leaf
const uint kIntersection = 3u;  // of planes of two leaves of a part
const uint kPartBorder = 4u;    // of two parts that touch
const uint kSilhouette = 5u;    // the surface ends, before something farther away or nothing
const uint kSectionEdge = 6u;   // of a face that a section left (npr/section.h), whatever else it is

struct LineFacts {
    uint kind;      // 0: no line
    int surfaces;   // all those before it
    int solids;     // that it is behind: how often the ray goes into opaque parts before it
    bool anchored;  // are the following known?
    float along;    // of the point in which the line of two planes is seen: its world coordinate by the axis to which
                    // the line is most parallel. So a point of the model has the same in every picture, and pieces of a
                    // bent line go on in each other
    float slope;    // by how much `along` changes on a unit of the line's length, 0.57 to 1
    float clearance;  // pixels to the border of what is nearer and hides what the line is on, kClear or more (as kClear)
    float remoteness;  // 0 at the near end of the scene, 1 at the far end
};

const float kClear = 7.0f;

LineFacts no_facts() {
    LineFacts f;
    f.kind = 0u;
    f.surfaces = 0;
    f.solids = 0;
    f.anchored = false;
    f.along = 0.0f;
    f.slope = 1.0f;
    f.clearance = kClear;
    f.remoteness = 0.0f;
    return f;
}

// Of surfaces, and of solids; that number stands for all larger ones.
const int kMostHiding = 127;

uvec2 pack_facts(LineFacts f) {
    uint counts = uint(min(f.surfaces, kMostHiding)) << 7 | uint(min(f.solids, kMostHiding));
    counts |= uint(clamp(f.clearance, 0.0f, kClear) + 0.5f) << 17 | uint(7.0f * f.remoteness + 0.5f) << 14;
    uint slope = uint(f.slope * 255.0f + 0.5f);
    return uvec2(f.kind << 29 | (f.anchored ? 1u : 0u) << 28 | slope << 20 | counts, floatBitsToUint(f.along));
}

LineFacts unpack_facts(uvec2 words) {
    LineFacts f;
    f.kind = words.x >> 29;
    f.anchored = (words.x >> 28 & 1u) != 0u;
    f.surfaces = int(words.x >> 7) & kMostHiding;
    f.solids = int(words.x) & kMostHiding;
    f.along = uintBitsToFloat(words.y);
    f.slope = float(words.x >> 20 & 255u) / 255.0f;
    f.clearance = float(words.x >> 17 & 7u);
    f.remoteness = float(words.x >> 14 & 7u) / 7.0f;
    return f;
}
