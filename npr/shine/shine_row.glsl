// What a pixel of a view-dependent picture shows. Valid in shaders and in C++ (npr/shine/shine_row.h).

struct ShineRow {
    int front;        // the layer of the nearest face of what is seen through; -1: none before what is opaque
    int last;         // the first layer that does not show, or the opaque surface that is seen
    int hidden;       // the first layer that does not show
    float alpha;      // opacity of the nearest face
    float front_ink;  // of silhouettes, on it
    float solid_ink;  // on the opaque surface
};

// The same before distances are known. Keys: 0 where there is no such surface, else of its part and whether it ends
// toward a neighboring pixel: see shine_key.
struct ShineSource {
    int front;
    int last;
    uint front_key;
    uint solid_key;
};
