// Colors are sRGB in schemes and parameters, linear light where samples are averaged.
vec3 linear_from_srgb(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}

vec3 srgb_from_linear(vec3 c) {
    return mix(c * 12.92, 1.055 * pow(max(c, vec3(1e-8)), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

// Straight alpha to what accumulates.
vec4 premultiplied(vec3 srgb, float alpha) {
    return vec4(linear_from_srgb(srgb) * alpha, alpha);
}
