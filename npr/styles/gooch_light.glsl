// Cool-to-warm shading (Gooch et al. 1998; Nienhaus 2005, listing 3-2). Valid in shaders and, within a struct with the
// same names, in C++.

// Lit, of a surface whose color is `base`. `direction`: of the ray, a unit vector in the eye's coordinates.
vec3 gooch_color(vec3 base, Surface s, vec3 direction, bool shadowed) {
    vec3 n = mat3(view.eye_from_world) * s.normal;
    float warmth = 0.5f * (dot(n, kLightDirection) + 1.0f);
    if (shadowed)
        warmth = min(warmth, 1.0f - warmth);  // As half_lit (npr/shadow.glsl) has it.
    vec3 cool = min(cool_color + diffuse_cool * base, 1.0f);
    vec3 warm = min(warm_color + diffuse_warm * base, 1.0f);
    float mirrored = max(dot(reflect(kLightDirection, n), direction), 0.0f);
    for (int i = 0; i < 5; ++i)
        mirrored *= mirrored;  // To the power of 32.
    return min(mix(cool, warm, warmth) + (shadowed ? 0.0f : specular * mirrored), 1.0f);
}
