// What the comparison of engines draws: models of the gallery, and families that grow.
#pragma once

#include <string>
#include <vector>

#include "csg/solid/placed.h"
#include "csg/tree/scene.h"
#include "gl/camera.h"
#include "goldfeather/products.h"

namespace bench {

/// A model made ready for every engine.
struct Subject {
    std::string name;
    double size = 0;  ///< What grows in its family; 0 for models of the gallery.
    csg::Scene scene;
    csg::solid::Geometry geometry;
    std::vector<std::vector<goldfeather::Product>> products;  ///< By part.
    std::size_t product_count = 0, triangles = 0;
    bool over_budget = false;  ///< Some part has no sum of products.
    gl::Camera camera;
};

/// Throws std::runtime_error where the file does not evaluate.
[[nodiscard]] Subject from_file(const std::string& path);

/// A model by its tree.
[[nodiscard]] Subject from_tree(std::string name, double size, const csg::Tree& tree, const gl::Camera& camera);

}  // namespace bench
