// Draws models without OpenGL: per-pixel lists, and painted styles.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "npr/painter/cpu_accumulate.h"
#include "ui/pipeline/picture/picture_request.h"
#include "ui/pipeline/statistics.h"

namespace ui {

/// Holds one model. All cores work on a picture.
class CpuRenderer {
  public:
    /// `minimal_fraction`: see goldfeather::EngineOptions.
    explicit CpuRenderer(double minimal_fraction) : minimal_fraction_(minimal_fraction) {}

    /// See Renderer; flat pictures are as they are to be drawn.
    void draw_sample(const Model& model, const npr::Picture& picture, int sample, const std::stop_token& stop = {});
    [[nodiscard]] base::Image image() const { return accumulator_.image(); }
    [[nodiscard]] std::optional<glm::dvec3> pick(const Model& model, const base::Camera& camera);
    /// Its choice of an engine is left to the caller.
    [[nodiscard]] const PictureStatistics& statistics() const { return statistics_; }

  private:
    /// What is made of a model once.
    struct Held {
        goldfeather::ListsModel lists;
        std::shared_ptr<const layers::SurfaceTable> table;
    };
    void hold(const Model& model);
    const npr::Paint& paint(const npr::StyleInfo& style);

    double minimal_fraction_;
    std::unique_ptr<const Held> model_;
    std::uint64_t generation_ = 0;  ///< Of the model that `model_` was made of.
    layers::HostStack layers_;      ///< Its memory is used again.
    npr::CpuAccumulator accumulator_;
    std::map<const npr::StyleInfo*, npr::Paint> styles_;  ///< Made when first used.
    PictureStatistics statistics_;
};

}  // namespace ui
