// How lines are drawn by what they are: a table that every style fills (npr/edges/line_types.h). Valid in shaders and,
// within a struct with the same names, in C++.

// Kinds of lines, and how hidden they are: by no solid, by one, by more.
const int kLineKinds = 6;
const int kVisibilities = 3;

struct LineType {
    float width;     // times that of the style
    float strength;  // of its ink, 0 to 1
    float dash;      // pixels, where the camera looks at
    float gap;       // between two dashes; 0: none
};

// Where in the table a line finds its type.
int type_of_line(LineFacts f) {
    return kVisibilities * int(max(f.kind, 1u) - 1u) + min(f.solids, kVisibilities - 1);
}

// The gap that lines leave where what they are on goes behind something nearer (haloed lines: Appel, Rohlf and Stein
// 1979). `gap`: pixels from the border of what is nearer; 0: none.
float halo_ink(LineFacts f, float gap) {
    return gap <= 0.0f || f.clearance >= kClear ? 1.0f : clamp(f.clearance - gap + 0.5f, 0.0f, 1.0f);
}

// A share of a line's width: less the farther it is, down to 1 - taper at the far end of the scene.
float weight_by_distance(LineFacts f, float taper) {
    return 1.0f - taper * f.remoteness;
}

// The same toward where a line ends before something nearer, `gap` pixels from its border: 1 - taper at the end.
float weight_by_end(LineFacts f, float gap, float taper) {
    if (taper <= 0.0f || f.clearance >= kClear)
        return 1.0f;
    return 1.0f - taper * (1.0f - clamp((f.clearance - gap) / (kClear - gap), 0.0f, 1.0f));
}

// Is there ink at this place of the line's pattern? Dashes lie on the model: their middles are where the coordinate
// along the line is a multiple of the period. `unit`: of the world, as large as a pixel where the camera looks at.
float pattern_ink(LineType t, LineFacts f, float unit) {
    if (t.gap <= 0.0f || !f.anchored)
        return 1.0f;
    float along = f.along / unit;
    float period = t.dash + t.gap;
    float from_middle = abs(along - period * floor(along / period + 0.5f));
    return clamp(0.5f * t.dash - from_middle + 0.5f, 0.0f, 1.0f);
}
