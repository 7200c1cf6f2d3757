// Kinds of parts, as the table of surfaces holds them (layers/surface_table.h). Valid in shaders and, within a struct,
// in C++.
const uint kPartSolid = 0u;
const uint kPartTranslucent = 1u;
const uint kPartBackground = 2u;
const uint kPartHighlight = 3u;
