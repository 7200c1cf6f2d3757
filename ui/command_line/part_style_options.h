// What the command line says of styles of parts (--style-of).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "csg/tree/scene.h"
#include "npr/part_style.h"

namespace ui {

/// 'part=NAME: STYLE,PARAMETER=VALUE,…', or 'color=COLOR: …', or 'module=NAME: …'. Throws std::runtime_error where it
/// is none, or there is no such style, parameter or value; names the nearest one.
[[nodiscard]] npr::PartStyle read_part_style(const std::string& text);

/// 'NAME', 'part=NAME', 'color=COLOR' or 'module=NAME', and maybe ',SHARE' above 0, at most 1. Throws
/// std::runtime_error where it is none of these.
[[nodiscard]] npr::RevealedPart read_revealed_part(const std::string& text);

/// Throws UsageError where one of them is of no part of the scene.
void need_parts(std::span<const npr::PartStyle> styles, const csg::Scene& scene);
void need_parts(std::span<const npr::RevealedPart> revealed, const csg::Scene& scene);

}  // namespace ui
