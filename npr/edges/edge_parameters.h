// Parameters that styles with edges share.
#pragma once

#include "npr/parameter.h"

namespace npr {

/// "width": of outlines, a length.
[[nodiscard]] Parameter line_width(float initial);
/// "inner-width" and "hidden-width": of inner edges and of hidden lines, times that of outlines. By default as ISO 128
/// has lines of three widths, 2 : 1.4 : 1.
[[nodiscard]] Parameter inner_line_width();
[[nodiscard]] Parameter hidden_line_width();
/// "crease": degrees between normals from which a bend is an edge.
[[nodiscard]] Parameter crease_angle();
/// "parts": whether boundaries of parts and of colors on smooth surfaces are edges.
[[nodiscard]] Parameter part_edges();
/// "section-width": of the edges of faces that sections leave, times that of outlines.
[[nodiscard]] Parameter section_line_width();
/// "halo": how far lines stop before what hides them, beside its own line; a length, 0: not at all.
[[nodiscard]] Parameter line_halo();
/// "taper": how much thinner lines are at the far end of the scene, 0 to 1.
[[nodiscard]] Parameter line_taper();
/// "taper-ends": how much thinner lines are where they end before what hides them, 0 to 1.
[[nodiscard]] Parameter line_taper_ends();
/// "layers": the first so many are drawn, or all.
[[nodiscard]] Parameter first_layers();

/// What counts as an edge.
struct EdgeSettings {
    float crease_degrees = 33;   ///< Between normals, from which a bend is an inner edge.
    bool parts = true;           ///< Whether boundaries of parts and of colors on smooth surfaces are inner edges.
    bool visible_only = false;   ///< Only edges that no opaque surface hides are asked for; there may be others.
    bool follow_borders = true;  ///< Whether outlines at faces seen edge-on are where the surface's border tells.
    bool clearances = false;     ///< Whether these are among the facts.
    bool facts = false;          ///< Whether what lines are is asked for, too (npr/edges/line_facts.glsl).
};

}  // namespace npr
