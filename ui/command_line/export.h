// The geometry of a model as files: meshes of solids, drawings of what is flat.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "ui/command_line/messages.h"
#include "ui/command_line/options.h"
#include "ui/pipeline/model.h"

namespace ui {

/// The mesh of a solid model, the outline of a flat one; neither where the model is empty or both.
struct Geometry {
    std::shared_ptr<const ModelMesh> mesh;
    bool mesh_known = false;  ///< From the cache.
    std::shared_ptr<const csg::solid::Outline> outline;

    /// to_json of what there is.
    [[nodiscard]] std::optional<Json> figures() const;
};

/// Both throw base::Stopped where `stop` asked for it. Throws ModelError where an output cannot hold the model, or its
/// mesh cannot be found. `builder` made the model.
[[nodiscard]] Geometry make_geometry(const Options& options, const Model& model, ModelBuilder& builder,
                                     Messages& messages, const std::stop_token& stop);

/// Writes the outputs that are meshes and drawings; `camera` looks at those that are scenes.
void write_geometry(const Options& options, const Model& model, const Geometry& geometry, const base::Camera& camera,
                    Messages& messages, const std::stop_token& stop);

}  // namespace ui
