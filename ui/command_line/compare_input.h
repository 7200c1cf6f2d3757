// What csgscope compare reads: the model, and what it is held against.
#pragma once

#include <memory>

#include "csg/scad/scad.h"
#include "ui/command_line/compare_options.h"
#include "ui/pipeline/mesh/mesh.h"
#include "ui/pipeline/model.h"

namespace ui {

/// `preview`: $preview, which is true for pictures and trees, and false for meshes. Throws ModelError where the program
/// has errors, which are printed.
[[nodiscard]] csg::scad::Evaluation evaluate(const CompareOptions& options, bool preview);

struct ComparedModel {
    std::shared_ptr<const Model> model;
    csg::scad::ViewSettings view;
};
[[nodiscard]] ComparedModel load(const CompareOptions& options);

/// Computed from the model, by openscad, or from a file. Throws UsageError, ModelError.
[[nodiscard]] csg::reference::Mesh reference_mesh(const CompareOptions& options, const Model& model);

}  // namespace ui
