// What the command line says of styles of parts (--style-of).
#pragma once

#include <span>
#include <string>

#include "csg/tree/scene.h"
#include "npr/part_style.h"

namespace ui {

/// 'part=NAME: STYLE,PARAMETER=VALUE,…', or 'color=COLOR: …', or 'module=NAME: …'. Throws std::runtime_error where it
/// is none, or there is no such style, parameter or value; names the nearest one.
[[nodiscard]] npr::PartStyle read_part_style(const std::string& text);

/// Throws UsageError where a style is of no part of the scene.
void need_parts(std::span<const npr::PartStyle> styles, const csg::Scene& scene);

}  // namespace ui
