// Light that parts keep from each other (npr/cast_shadows.h), for styles with a setting `cast_shadows`. Valid in shaders
// and, within a struct with the same names, in C++.

bool in_shadow(ivec2 pixel, int layer) {
    return cast_shadows && shadows_known && layer < 32 && ((shadow_bits(pixel) >> uint(layer)) & 1u) != 0u;
}

// Of light that falls from 0 (from behind) to 1 (straight). In the shadow a surface looks as one does that is turned
// away as far as this is turned to the light: so shadows are darker than sides away from the light, and end where those
// begin without a step.
float half_lit(float facing, bool shadowed) {
    return shadowed ? min(facing, 1.0f - facing) : facing;
}
