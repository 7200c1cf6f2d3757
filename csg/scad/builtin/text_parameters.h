// The parameters of text(), textmetrics() and fontmetrics().
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "csg/scad/value/value.h"
#include "csg/tree/leaf_shape.h"

namespace csg::scad {

/// A text of what `parameter` gives by name (undef where it is not given); what has the wrong type is warned of, in
/// the name of `caller`, and counts as not given. Script and direction are found out where they are not told; fonts of
/// `use` are left to the caller.
[[nodiscard]] Text read_text_parameters(std::string_view caller,
                                        const std::function<const Value&(std::string_view)>& parameter,
                                        const std::function<void(std::string)>& warn);

}  // namespace csg::scad
