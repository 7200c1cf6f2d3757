// Homogeneous media that a ray passes (Barta and Kovács 2011): a segment of length d in a medium of attenuation tau lets
// exp(-tau d) of the light through and adds albedo * light * (1 - exp(-tau d)). Where media overlap, attenuations add,
// and albedos by attenuation. Valid in shaders and, within a struct, in C++.

// The media about a point: albedo times attenuation, and attenuation, in whole numbers of some unit, each in two
// halves. So no order in which media are entered and left makes a difference, and nothing is left of those left.
struct Media {
    ivec4 high;
    ivec4 low;
    float at;  // the point's distance from the eye's plane, along the axis of view
};

const float kMediumHalf = 32768.0f;  // units of the high half

Media no_media(float at) {
    Media m;
    m.high = ivec4(0);
    m.low = ivec4(0);
    m.at = at;
    return m;
}

// Beyond the surface of a medium.
Media crossed(Media m, ivec4 high, ivec4 low, bool leaving) {
    m.high += leaving ? -high : high;
    m.low += leaving ? -low : low;
    return m;
}

// Albedo times attenuation, and attenuation.
vec4 density(Media m, float unit) {
    return max(vec4(m.high) * kMediumHalf + vec4(m.low), 0.0f) * unit;
}

// Through a segment of this density and length. `light`: by which the medium would show its albedo.
Composite through_medium(Composite c, vec4 density, float light, float length) {
    if (density.w <= 0.0f)
        return c;
    float clear = float(exp(-density.w * length));
    c.color += c.through * (1.0f - clear) * min(vec3(density) / density.w * light, 1.0f);
    c.through *= clear;
    return c;
}

// Light scattered to the eye, by the cosine of the angle between ray and light: Rayleigh's phase function
// 3 / (16 pi) (1 + cos^2), with 1 as its mean.
float rayleigh(float cosine) {
    return 0.75f * (1.0f + cosine * cosine);
}
