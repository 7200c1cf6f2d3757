// What one pass a frame makes of the triangles (prepare.comp) and every geometry pass draws: equal vertices give equal
// pixels, and faces on one canonical plane give bit-equal depth from every leaf.
struct TriangleRow {
    vec4 plane_depth;   // see View::PlaneDepth; w: edge-on
    vec2 depth_limits;  // least and greatest depth of the vertices
    uint plane;
    uint leaf;
};
