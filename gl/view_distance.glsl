// Valid in shaders and, within a struct with the same names, in C++.

// Distance from the eye's plane along the axis of view.
float view_distance(float depth) {
    return view.depth_range.z > 0.5f ? mix(view.depth_range.y, view.depth_range.x, depth) : view.depth_range.x / depth;
}
