// What shaders and C++ agree on about edges, and about the lines that are drawn along them.
#pragma once

#include <glm/glm.hpp>

namespace npr {

namespace shader {

using namespace glm;  // Shader files say vec2 and min.

struct LineCode {
#include "npr/edges/edge_point.glsl"

#include "npr/edges/line_facts.glsl"

#include "npr/edges/line_types.glsl"
};

}  // namespace shader

using LineFacts = shader::LineCode::LineFacts;

/// See npr/edges/line_facts.glsl.
enum class LineKind : glm::uint {
    ColorBorder = shader::LineCode().kColorBorder,
    Crease = shader::LineCode().kCrease,
    Intersection = shader::LineCode().kIntersection,
    PartBorder = shader::LineCode().kPartBorder,
    Silhouette = shader::LineCode().kSilhouette,
    SectionEdge = shader::LineCode().kSectionEdge,
};

}  // namespace npr
