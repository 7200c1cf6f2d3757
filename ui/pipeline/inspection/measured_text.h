// What was measured, in words and as JSON.
#pragma once

#include <string>

#include "csg/scad/scad.h"
#include "ui/pipeline/inspection/measured.h"
#include "ui/pipeline/json.h"

namespace ui {

/// "cylinder, radius 2.5, diameter 5": one line for a list.
[[nodiscard]] std::string headline(const Measured& thing);

/// Lines for people below the headline, each with its end: where it lies, how exact it is, and the call that made it.
[[nodiscard]] std::string details(const Model& model, const csg::scad::SourceSet& sources, const Measured& thing);

/// Lines for people: distance, differences along the axes, angle; and why there is none.
[[nodiscard]] std::string relation_text(const Measured& a, const Measured& b, const Relation& relation);

/// {"kind": "cylinder", "at": …, "radius": …, "diameter": …, "axis": {"point": …, "direction": …}, "exact": …, …}
[[nodiscard]] Json to_json(const Model& model, const csg::scad::SourceSet& sources, const Measured& thing);

/// {"distance": …, "from": …, "to": …, "minimum": …, "maximum": …, "angle": …, "parallel": …}
[[nodiscard]] Json to_json(const Relation& relation);

}  // namespace ui
