// Tones of a radiograph. Valid in shaders and, within a struct, in C++.

const int kFilm = 0;    // what is thick is bright
const int kPaper = 1;   // what is thick is dark
const int kHeat = 2;    // black, red, yellow, white
const int kValues = 3;  // none: millimeters

// sRGB; `share`: of the full tone, from 0 to 1.
vec3 radiograph_tone(int colors, float share) {
    if (colors == kPaper)
        return vec3(1.0f - share);
    if (colors == kHeat)
        return clamp(vec3(3.0f * share, 3.0f * share - 1.0f, 3.0f * share - 2.0f), 0.0f, 1.0f);
    return vec3(share);
}
