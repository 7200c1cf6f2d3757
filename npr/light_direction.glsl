// Valid in shaders and, within a struct, in C++.
const vec3 kLightDirection = vec3(-0.57735027f, 0.57735027f, 0.57735027f);  // in the eye's coordinates
