// csgscope compare --against openscad: beside the layers of its mesh, its tree, its volume and its picture.
#pragma once

#include <string>

#include "base/camera.h"
#include "ui/command_line/openscad_process.h"
#include "ui/pipeline/json.h"
#include "ui/pipeline/mesh/mesh.h"
#include "ui/pipeline/model.h"

namespace ui {

/// `tree`: the model's .csg text; `theirs`: facts of openscad's mesh. Volumes agree where they differ by no more than
/// the six digits of openscad's file allow. {"tree_agrees": …, "volume": …, "picture": …}; the picture, which needs a
/// display, is null where there is none, and else the share of pixels that only one of the two covers.
[[nodiscard]] Json compare_with_openscad(const OpenscadProcess& openscad, const std::string& tree, const Model& model,
                                         const csg::reference::MeshFacts& theirs, const base::Camera& camera,
                                         glm::ivec2 size);

}  // namespace ui
