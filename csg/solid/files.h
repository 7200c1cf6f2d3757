// Shapes from files. Whatever is wrong with a file is a warning, and what could be read up to there is taken.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "csg/solid/outline.h"
#include "csg/solid/solid.h"

namespace csg::solid {

/// stl, off, obj, amf, 3mf, by the name's end.
[[nodiscard]] std::shared_ptr<Solid> import_solid(const Import& import);

/// dxf, svg.
[[nodiscard]] Outline import_outline(const Import& import, std::vector<std::string>& warnings);

/// A height map of a picture (png) or of a table of numbers.
[[nodiscard]] std::shared_ptr<Solid> surface_solid(const Surface& surface);

}  // namespace csg::solid
