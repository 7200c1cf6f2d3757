// Object-space screen doors: of the samples of a surface some are opaque and the others are not there. Samples lie on the
// surface, as large as a sample of the picture where the surface faces the eye; so tilted surfaces, of which a pixel
// holds more, are more opaque. Valid in shaders and, within a struct with the same names, in C++.

const uint kDoorSide = 16u;      // samples along a mask, of which a share is opaque
const float kMostTilted = 32.0f;  // samples that lie behind one of the picture's, at most

uint door_hash(uint x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ x >> 16;
}

// The place of a sample in a random order of those of its mask, 0 to 255: each is there once.
uint door_rank(uint sample_in_mask, uint key) {
    uint x = sample_in_mask;
    for (int i = 0; i < 3; ++i) {
        key = door_hash(key + 0x9e3779b9u);
        x = (x * (key | 1u) + (key >> 9)) & 255u;
        x ^= x >> 4;
    }
    return x;
}

// One sample of a surface, on which coordinates are counted in samples.
bool door_sample(ivec2 cell, uint surface_key, uint opaque_samples) {
    ivec2 mask = ivec2(cell.x >> 4, cell.y >> 4);
    uint key = door_hash(door_hash(surface_key ^ uint(mask.x)) ^ uint(mask.y));
    uint in_mask = (uint(cell.y) & (kDoorSide - 1u)) * kDoorSide + (uint(cell.x) & (kDoorSide - 1u));
    return door_rank(in_mask, key) < opaque_samples;
}

// Is the surface opaque where the pixel's sample sees it? `s`: of an opacity between 0 and 1.
bool behind_door(Surface s, float opacity, ivec2 pixel, vec3 ray) {
    vec4 row = plane_rows[s.plane];
    mat3 turn = mat3(view.eye_from_world);
    vec3 normal = vec3(row);
    vec3 n = turn * normal;
    float offset = row.w + dot(n, center_in_eye);
    vec2 at = picture_position(pixel);
    bool flat_view = view.depth_range.z > 0.5f;
    vec3 p = flat_view ? vec3(at, (offset - dot(vec2(n), at)) / n.z) : vec3(at, -1.0f) * (offset / dot(n, vec3(at, -1.0f)));
    // From local_center; axes on the plane, the same from wherever it is seen.
    vec3 place = (p - center_in_eye) * turn;
    vec3 up = abs(normal.z) > 0.999f ? vec3(0.0f, 1.0f, 0.0f) : vec3(0.0f, 0.0f, 1.0f);
    vec3 right = normalize(cross(up, normal));
    vec3 ahead = cross(normal, right);
    // Sizes go in powers of two, so that samples stay where they are while the eye comes a little nearer.
    float wanted = door_size * 2.0f * view.picture.z / view.picture.y * (flat_view ? 1.0f : -p.z);
    float level = ceil(log2(max(wanted, 1e-30f)));
    vec2 coordinate = vec2(dot(place, right), dot(place, ahead)) * exp2(-level);
    uint key = door_hash(floatBitsToUint(row.w)) ^ door_hash(floatBitsToUint(normal.x + 2.0f * normal.y + 4.0f * normal.z));
    key ^= uint(int(level));
    uint opaque_samples = uint(opacity * float(kDoorSide * kDoorSide) + 0.5f);
    ivec2 cell = ivec2(floor(coordinate));
    if (door_sample(cell, key, opaque_samples))
        return true;
    if (!door_tilt)
        return false;
    // The others that lie behind one of the picture's, in the direction in which it is seen at a slant.
    vec3 direction = normalize(ray);
    float facing = max(abs(dot(direction, normal)), 1.0f / kMostTilted);
    vec2 slant = vec2(dot(direction, right), dot(direction, ahead));
    slant = slant / max(max(abs(slant.x), abs(slant.y)), 1e-6f);
    float beside = 1.0f / facing - 1.0f;
    int count = int(beside) + (float(door_hash(key ^ uint(cell.x * 7919 + cell.y)) >> 8) / 16777216.0f < fract(beside) ? 1 : 0);
    for (int i = 1; i <= count; ++i) {
        float step = float((i + 1) / 2) * (i % 2 == 1 ? 1.0f : -1.0f);
        if (door_sample(ivec2(floor(coordinate + step * slant)), key, opaque_samples))
            return true;
    }
    return false;
}
