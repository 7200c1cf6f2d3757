// A place that messages and selections point to.
#pragma once

#include <memory>

#include "csg/scad/source/source.h"

namespace ui {

struct TextPlace {
    std::shared_ptr<const csg::scad::SourceFile> text;  ///< Null where nothing is meant.
    csg::scad::SourceRange range;                       ///< Not known() where all of it is.
};

}  // namespace ui
