// A solid that is scaled by hand, as edits of the text that made it.
#pragma once

#include "ui/pipeline/editing/edit_ways.h"

namespace ui {

/// The leaf becomes so many times as large along the axes of its own coordinates, from their origin: its own numbers
/// change, where a cube, a sphere or a cylinder can be so, or those of a scale(), or one is put in. `factors`: above 0.
/// The rest, and what it throws: edit_ways().
[[nodiscard]] std::vector<MoveWay> ways_to_scale(const csg::Tree& tree, const csg::Scene& scene,
                                                 const csg::scad::LoadedProgram& program, const std::string& text,
                                                 csg::LeafId leaf, const glm::dvec3& factors, const TreeOfText& tree_of,
                                                 const std::stop_token& stop = {}, Ways wanted = Ways::All);

}  // namespace ui
