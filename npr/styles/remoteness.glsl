// Valid in shaders and, within a struct with the same names, in C++.

// 0 at the near end of the scene, 1 at the far end.
float remoteness(Surface s) {
    return clamp(0.5f + (view_distance(s.depth) + center_in_eye.z) / view.depth_range.w, 0.0f, 1.0f);
}
