// Models and their meshes, as the tests of csg/reference need them.
#pragma once

#include <string>

#include "tests/random/random_tree.h"
#include "ui/pipeline/comparison/errors.h"
#include "ui/pipeline/comparison/solid_scene.h"
#include "ui/pipeline/mesh/mesh.h"

namespace meshes {

/// The program's model, with $preview false. Throws std::runtime_error where it has errors.
[[nodiscard]] std::shared_ptr<const ui::Model> model_of(const std::string& program);

struct PictureErrors {
    ui::Errors all, outside;  ///< Outside: without the band of one pixel along silhouettes and creases.
};

/// Errors of the CPU engine's picture against the mesh, all layers, from six views, both projections.
[[nodiscard]] PictureErrors picture_errors(const csg::Scene& scene, const csg::solid::Geometry& geometry,
                                           const csg::reference::Mesh& mesh, int size);

}  // namespace meshes
