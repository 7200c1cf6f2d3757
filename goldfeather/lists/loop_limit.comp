// How many iterations of a loop does the driver run?
layout(local_size_x = 1) in;

layout(std430, binding = 2) buffer Result { uint iterations; };

uniform uint wanted;  // Not known when the shader is compiled.

void main() {
    uint state = 1u, done = 0u;
    // The end depends on every iteration, so that the loop cannot be replaced by its result.
    while (done < wanted && state != 0u) {
        state = state * 1664525u + 1013904223u | 1u;
        ++done;
    }
    iterations = done;
}
