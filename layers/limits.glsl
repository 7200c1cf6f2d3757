// Limits of layers that shaders share. Valid in shaders and, within a struct, in C++ (layers/limits.h).

// Whoever keeps something by layer in a fixed number of places (a bit of a mark, a slice of a texture) has so many; the
// last one is that of all deeper layers, too.
const int kLayersApart = 16;
