// Draws models without OpenGL: per-pixel lists, and painted styles.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "goldfeather/engine_set.h"
#include "goldfeather/smooth_facets.h"
#include "layers/host_stack.h"
#include "npr/painter/cpu_accumulate.h"
#include "npr/part_painter.h"
#include "npr/sorted/sorted_painter.h"
#include "ui/pipeline/picture/picture_request.h"
#include "ui/pipeline/picture/shadow_caster.h"
#include "ui/pipeline/picture/sorted_mesh.h"
#include "ui/pipeline/statistics.h"

namespace ui {

/// Holds one model, for an engine that needs no OpenGL. All cores work on a picture.
class CpuRenderer {
  public:
    /// `minimal_fraction`: see goldfeather::EngineOptions.
    explicit CpuRenderer(double minimal_fraction) : engines_({.minimal_fraction = minimal_fraction}) {}

    /// See Renderer; flat pictures are as they are to be drawn.
    void draw_sample(const Model& model, const npr::Picture& picture, const goldfeather::EngineInfo& engine, int sample,
                     const std::stop_token& stop = {});
    /// The same of layers that another has peeled.
    using Peel = std::function<std::shared_ptr<const layers::HostStack>(const base::View& view, int layers)>;
    void draw_sample(const Model& model, const npr::Picture& picture, int sample, const Peel& peel,
                     const std::stop_token& stop = {});
    /// The same of the model's mesh (draws_sorted).
    void draw_sorted(const Model& model, const npr::Picture& picture, int sample, const std::stop_token& stop = {});
    [[nodiscard]] std::vector<glm::vec4> light() const { return accumulator_.light(); }
    [[nodiscard]] base::Image image() const { return accumulator_.image(); }
    /// The first surfaces of a view of one pixel (0: all).
    [[nodiscard]] std::shared_ptr<const layers::HostStack> pick(const Model& model, const base::View& view, int layers,
                                                                const goldfeather::EngineInfo& engine);
    /// See Renderer.
    void update(const Model& model, const csg::solid::SceneChange& change);
    /// Its choice of an engine is left to the caller.
    [[nodiscard]] const PictureStatistics& statistics() const { return statistics_; }

  private:
    void begin(int sample);
    void paint_sample(const Model& model, const npr::Picture& picture, int sample,
                      const std::function<const layers::HostStack&(const base::View&)>& peel,
                      const std::stop_token& stop);
    /// What is left of a stack; how much is taken away is the same for all samples.
    const layers::HostStack& reveal(const npr::Picture& picture, const layers::HostStack& stack, int sample);
    void hold(const Model& model, const goldfeather::EngineInfo& engine);
    const npr::Paint& paint(const npr::StyleInfo& style);

    goldfeather::EngineSet engines_;
    std::shared_ptr<layers::SurfaceTable> table_;        ///< Of the model that is held.
    std::unique_ptr<goldfeather::PreparedScene> scene_;  ///< The same, for the engine that it is held for.
    const goldfeather::EngineInfo* engine_ = nullptr;
    std::uint64_t generation_ = 0;  ///< Of the model.
    bool edited_ = false;           ///< It has been; then what it is shaded by is kept.
    goldfeather::SmoothFacetKeeper facets_;
    layers::Stack stack_;  ///< Of the last sample.
    npr::CpuAccumulator accumulator_;
    std::map<const npr::StyleInfo*, npr::Paint> styles_;  ///< Made when first used.
    layers::HostStack revealed_;
    npr::PartPainter parts_;
    PartMeshes meshes_;
    ShadowCasters shadows_;
    std::unique_ptr<npr::SortedPainter> sorted_;  ///< Of the model and scheme in its last picture; null before.
    std::uint64_t sorted_generation_ = 0;
    npr::ColorScheme sorted_scheme_;
    std::shared_ptr<const layers::SurfaceTable> sorted_table_;  ///< Of its faces, where styles color them.
    PictureStatistics statistics_;
};

}  // namespace ui
