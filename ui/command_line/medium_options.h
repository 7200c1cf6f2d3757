// What the command line says of media (`--transparency volume`).
#pragma once

#include <span>
#include <string>

#include "csg/tree/scene.h"
#include "npr/transparency.h"

namespace ui {

/// 'PART: tau=0.3/mm, albedo=#aabbcc', or one of the two. Throws UsageError.
[[nodiscard]] npr::PartMedium read_medium(const std::string& text);

/// 'AMBIENT,DIRECTIONAL', 0 or more. Throws UsageError.
[[nodiscard]] npr::MediumLight read_medium_light(const std::string& text);

/// Throws UsageError where the scene has no part of a name; it gives the nearest one.
void need_parts(std::span<const npr::PartMedium> media, const csg::Scene& scene);

}  // namespace ui
