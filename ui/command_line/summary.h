// --summary and --summary-file, in OpenSCAD's form.
#pragma once

#include <optional>
#include <stop_token>

#include "base/camera.h"
#include "csg/solid/placed.h"
#include "csg/tree/box.h"
#include "ui/command_line/summary_parts.h"
#include "ui/pipeline/json.h"
#include "ui/pipeline/model.h"

namespace ui {

struct SummaryFigures {
    base::Camera camera;
    csg::Box box;                  ///< Encloses the model; empty where it is.
    std::optional<Json> geometry;  ///< to_json of the mesh or of the outline.
    csg::solid::SolidCache::Size cache;
    double milliseconds = 0;  ///< Wall time of the run so far.
    Json parts;               ///< See parts_json.
    Json measures;            ///< See measures_json.
};

/// [{"name": …, "kind": …, "color": …, "leaves": …, "bounding_box": …}]; boxes enclose the parts.
[[nodiscard]] Json parts_json(const Model& model);

/// {"volume": …, "volume_error": …, "area": …, "area_error": …, "centroid": …, "centroid_error": …, "moments": …,
/// "moments_error": …, "bounding_box": …, "spacing": …, "parts": [{"name": …, "volume": …, …}]} by layers.
[[nodiscard]] Json measures_json(const Model& model, double precision, const std::stop_token& stop);

/// {"cache": …, "time": …, "camera": …, "bounding_box": …, "geometry": …, "parts": …, "measures": …}, of which `parts`
/// are told.
[[nodiscard]] Json summary_json(const SummaryParts& parts, const SummaryFigures& figures);

}  // namespace ui
