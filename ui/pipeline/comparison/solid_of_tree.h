// How large the solid of a tree is.
#pragma once

#include <stop_token>

#include "csg/tree/box.h"
#include "csg/tree/tree.h"

namespace ui {

struct MeasuredSolid {
    double volume = 0;
    csg::Box box;  ///< Empty where there is nothing.
};

/// Of the exact mesh. Throws ModelError where an object of it cannot be made, or it is flat, base::Stopped where `stop`
/// asked for it.
[[nodiscard]] MeasuredSolid solid_of(csg::Tree tree, const std::stop_token& stop = {});

}  // namespace ui
