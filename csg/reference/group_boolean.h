// The mesh of one group of leaves, by the first method that gives one, checked.
#pragma once

#include "csg/reference/boolean.h"
#include "csg/reference/leaf_groups.h"

namespace csg::reference {

/// A simple leaf alone is copied, unless a method is asked for; else by planes, and exactly where they cannot decide.
/// Errors as make_mesh (boolean.h).
[[nodiscard]] BooleanResult group_boolean(const LeafGroups& groups, std::size_t group, const BooleanRequest& request,
                                          unsigned threads);

}  // namespace csg::reference
