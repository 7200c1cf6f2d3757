// Shapes from files. What could be read of a file is taken; what of it could not is a failure.
#pragma once

#include <memory>
#include "csg/solid/outline.h"
#include "csg/solid/remarks.h"
#include "csg/solid/solid.h"

namespace csg::solid {

/// stl, off, obj, amf, 3mf, by the name's end.
[[nodiscard]] std::shared_ptr<Solid> import_solid(const Import& import);

/// dxf, svg.
[[nodiscard]] Outline import_outline(const Import& import, Remarks& remarks);

/// A height map of a picture (png) or of a table of numbers.
[[nodiscard]] std::shared_ptr<Solid> surface_solid(const Surface& surface);

}  // namespace csg::solid
