// A model's boolean mesh, and the mesh as a file: only when somebody asks.
#pragma once

#include <string>
#include <vector>

#include "csg/reference/boolean.h"
#include "csg/reference/mesh_files.h"
#include "ui/pipeline/json.h"
#include "ui/pipeline/model.h"

namespace ui {

using csg::reference::MeshFormat;

struct ModelMesh {
    csg::reference::Mesh mesh;  ///< Sources are leaves of the model's scene.
    csg::reference::MeshFacts facts;
    std::string method, reason;  ///< How it was found, and why not by planes.
    double boolean_ms = 0;       ///< Wall time.
};

/// The solid and translucent parts as one closed mesh. Throws ModelError where there is nothing, no closed mesh, or an
/// object that could not be made, base::Stopped where `stop` asked for it.
[[nodiscard]] ModelMesh make_mesh(const Model& model, const std::stop_token& stop = {});

/// The bytes of a file; `view` is for scenes. Parts of the file are the colors of the model; each is named by the place
/// in the source where the first object of that color stands.
[[nodiscard]] std::string encode_mesh(const Model& model, const ModelMesh& mesh, MeshFormat format,
                                      const csg::reference::ThreeMfOptions& three_mf = {},
                                      const csg::reference::PovView& view = {}, const std::stop_token& stop = {});

/// For summaries, in OpenSCAD's form: {"dimensions": 3, "facets": …, "vertices": …, "simple": true, "area": …,
/// "volume": …, "bounding_box": {"min": …, "max": …, "size": …}}.
[[nodiscard]] Json to_json(const ModelMesh& mesh);

}  // namespace ui
