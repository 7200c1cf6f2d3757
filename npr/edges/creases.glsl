// Which bends are creases, by what made them: the smooth surfaces of leaves. Valid in shaders and, within a struct with
// the same names, in C++.

#include "layers/smooth_groups.glsl"

// Radians, from which a bend between two surfaces is a crease. Surfaces of one leaf were told apart with more care when
// they were made: what is left to be left out is what a matrix has made flat.
const float kLeastCrease = 0.052359878f;
const float kLeastOfLeaf = 0.017453293f;
const float kNever = 4.0f;  // more than any angle
// Where leaves of one tessellation go on in each other, the angle is just what their facets leave open, but for rounding.
const float kRoundedBend = 1e-3f;
const float kUsualCrease = 0.5759f;  // a little less than the 33 degrees of the parameter
// By so much more at most the angle between facets may be that are not neighbors.
const float kCurved = 0.288f;

// The angle beyond which a joint of two surfaces that meet is a crease. Facets stand for a surface that bends between
// them, and their normals are off its normal by up to half of that: two leaves that are off by no more may be tangent,
// or one and the same surface in other facets.
float crease_limit(Surface s, Surface t) {
    Groups a = groups_of(s.plane, s.leaf);
    Groups b = groups_of(t.plane, t.leaf);
    if (s.leaf != t.leaf)
        return max(kLeastCrease, 0.5f * (bend_of(a) + bend_of(b)) + kRoundedBend);
    if (!one_surface(a, b))
        return kLeastOfLeaf;
    // An angle below the usual one asks for bends within surfaces that are only estimated. Across a corner where four
    // facets meet the angle is that of two bends.
    bool asked = (leaf_rows[s.leaf].part.w & 1u) != 0u && crease_angle < kUsualCrease;
    return asked ? max(crease_angle, 1.5f * max(bend_of(a), bend_of(b))) : kNever;
}
