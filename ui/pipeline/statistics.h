// What a run cost, as JSON (--stats, benchmarks).
#pragma once

#include "base/camera.h"
#include "goldfeather/choice.h"
#include "goldfeather/walk_stats.h"
#include "npr/reveal.h"
#include "npr/sorted/index_sort.h"
#include "ui/pipeline/json.h"
#include "ui/pipeline/model.h"

namespace ui {

/// The cost of one picture. Times are wall time in milliseconds, over all samples.
struct PictureStatistics {
    goldfeather::EngineChoice engine;
    goldfeather::WalkStats walk;  ///< Passes, bands and fragments summed over samples, the rest at its largest.
    int samples = 0;
    bool opengl = false;   ///< Whether OpenGL drew the style; else the CPU painted it.
    double upload_ms = 0;  ///< 0 where the renderer held the model already.
    double peel_ms = 0;
    double style_ms = 0;
    double read_ms = 0;
    npr::Revealed revealed;             ///< In pictures that reveal parts.
    std::vector<npr::SortCount> sorts;  ///< In `sorted`: of each picture of the model so far.
    std::size_t sorted_triangles = 0;   ///< Of the mesh; 0 where none was drawn.
};

/// [x, y, z]
[[nodiscard]] Json to_json(const glm::dvec3& v);

/// OpenSCAD's four numbers: {"translation": …, "rotation": …, "distance": …, "fov": …}.
[[nodiscard]] Json to_json(const base::Camera& camera);

/// Counts and stages of a model: {"leaves": …, "products": …, "ms": {"place": …, "normalize": …}}.
[[nodiscard]] Json to_json(const ModelStatistics& statistics);

/// {"passes": …, "fragments": …, "layers": …, "samples": …, "ms": {"upload": …, "peel": …, "style": …, "read": …}}.
[[nodiscard]] Json to_json(const PictureStatistics& statistics);

}  // namespace ui
