// Outlines among solids, and solids among outlines: what a node combines is of one dimension, that of its first child
// that makes anything (csg/tree/dimension.h). What the newest OpenSCAD says of the others. Internal to csg/solid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "csg/solid/node_geometry.h"

namespace csg::solid {

/// In the order they are said. A child is told of where it stands: the same content may stand elsewhere.
[[nodiscard]] std::vector<ChildRemark> misplaced_children(const Tree& tree, NodeId id,
                                                          std::span<const NodeGeometry* const> children);

/// Of one child after the other of a node in space: what there is to say of an outline.
class MisplacedOutlines {
  public:
    MisplacedOutlines(const Tree& tree, NodeId parent);
    /// None, one or both of the two texts.
    [[nodiscard]] std::vector<const char*> next(bool empty);

  private:
    bool combines_, tells_of_empty_;
    bool mixing_told_ = false;
};

}  // namespace csg::solid
