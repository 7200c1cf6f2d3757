// A solid that is moved, turned or stretched by hand, as edits of the text that made it.
#pragma once

#include "ui/pipeline/editing/edit_ways.h"

namespace ui {

/// After each the leaf is what it was and lies within 1e-6 of where it was put. `by`: world units. The rest, and what
/// it throws: edit_ways().
[[nodiscard]] std::vector<MoveWay> ways_to_move(const csg::Tree& tree, const csg::Scene& scene,
                                                const csg::scad::LoadedProgram& program, const std::string& text,
                                                csg::LeafId leaf, const glm::dvec3& by, const TreeOfText& tree_of,
                                                const std::stop_token& stop = {}, Ways wanted = Ways::All);

/// The leaf is turned about the origin of its own coordinates. `turn`: in the world, a vector along the axis as long as
/// the angle in degrees, counter-clockwise seen from its tip; less than half a turn.
[[nodiscard]] std::vector<MoveWay> ways_to_turn(const csg::Tree& tree, const csg::Scene& scene,
                                                const csg::scad::LoadedProgram& program, const std::string& text,
                                                csg::LeafId leaf, const glm::dvec3& turn, const TreeOfText& tree_of,
                                                const std::stop_token& stop = {}, Ways wanted = Ways::All);

/// Both ends of the box of a leaf's own shape along one of its axes (0 to 2); of round ones by their radius. Nothing
/// where its own numbers do not tell them: of a mesh operation but linear_extrude() along its height.
[[nodiscard]] std::optional<glm::dvec2> leaf_extent(const csg::Tree& tree, csg::NodeId leaf, int axis);

/// One side of the leaf's box, in its own coordinates, moves out by so much (world units; inwards below 0): its shape
/// changes. What else of it changes, as the other side of a centered one, is as the program has it. `axis`: 0 to 2.
/// None where leaf_extent() has none.
[[nodiscard]] std::vector<MoveWay> ways_to_stretch(const csg::Tree& tree, const csg::Scene& scene,
                                                   const csg::scad::LoadedProgram& program, const std::string& text,
                                                   csg::LeafId leaf, int axis, bool upper, double by,
                                                   const TreeOfText& tree_of, const std::stop_token& stop = {},
                                                   Ways wanted = Ways::All);

}  // namespace ui
