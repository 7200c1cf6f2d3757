// Random models, their simplifications, and their text as OpenSCAD programs.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <random>
#include <string>
#include <vector>

#include "base/camera.h"
#include "csg/tree/tree.h"

namespace random_tree {

/// A node of a model by value; the kinds are those of csg::Operation.
struct Model {
    csg::Operation operation = csg::Operation::Union;
    csg::Modifiers modifiers;
    csg::LeafShape shape = csg::Cube{};  ///< Leaf
    glm::dmat4 matrix{1.0};              ///< Transform
    csg::Rgba color;                     ///< Color
    std::vector<Model> children;
};

struct Options {
    int most_leaves = 14;
    int depth = 5;
    bool modifiers = true;  ///< `%`, `#` and translucent colors, which make further parts.
    bool wound = false;     ///< Polyhedra of shells that overlap, lie in each other, are reversed or doubled, or cross.
};

/// Nested operations on shapes with coordinates from a small grid, so that faces often coincide; some leaves are
/// repeated in other roles, some have no volume. The same engine state gives the same model on every machine.
[[nodiscard]] Model make_model(std::mt19937_64& random, const Options& options = {});

/// A view of the box: of both projections, sometimes with the eye inside it.
[[nodiscard]] base::Camera make_camera(std::mt19937_64& random, const glm::dvec3& lo, const glm::dvec3& hi);

[[nodiscard]] csg::Tree make_tree(const Model& model);

/// Models with one thing less: for shrinking.
[[nodiscard]] std::vector<Model> simpler(const Model& model);

/// The model as an OpenSCAD program.
[[nodiscard]] std::string scad_text(const Model& model);

/// The camera as OpenSCAD's special variables ($vpt, $vpr, $vpd, $vpf) and projection, in a comment.
[[nodiscard]] std::string camera_text(const base::Camera& camera);

}  // namespace random_tree
