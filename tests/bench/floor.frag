// Lit as the style `shaded` does it.
flat in vec3 eye_normal;
out vec4 color;

void main() {
    float light = 0.2 + abs(dot(eye_normal, vec3(-0.57735027, 0.57735027, 0.57735027)));
    color = vec4(min(vec3(0.98, 0.84, 0.17) * light, 1.0), 1.0);
}
