// Draws models with OpenGL: from a Model to a picture, in one context.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/camera.h"
#include "base/image.h"
#include "gl/context.h"
#include "goldfeather/choice.h"
#include "goldfeather/engine_set.h"
#include "layers/upload.h"
#include "npr/accumulate.h"
#include "npr/style.h"
#include "ui/pipeline/model.h"
#include "ui/pipeline/picture/picture_request.h"
#include "ui/pipeline/picture/shadow_caster.h"
#include "ui/pipeline/picture/sorted_mesh.h"
#include "ui/pipeline/statistics.h"

namespace ui {

/// Holds one model on the GPU and the programs of all styles. Its context must be current whenever it is used, and
/// outlive it. Throws gl::Error where OpenGL cannot give what a picture needs, and ModelError where the engine asked
/// for cannot draw the model.
class GlRenderer {
  public:
    /// See goldfeather::EngineOptions.
    GlRenderer(const gl::Context& context, std::size_t memory_budget, double minimal_fraction);

    /// See Renderer; flat pictures are as they are to be drawn. `engine`: the same for all samples of a picture.
    void draw_sample(const Model& model, const npr::Picture& picture, const goldfeather::EngineChoice& engine,
                     int sample, const std::stop_token& stop = {});
    void resolve(GLuint target, glm::ivec2 corner) { accumulator_.resolve(target, corner); }
    [[nodiscard]] std::vector<glm::vec4> light() const { return accumulator_.light(); }
    [[nodiscard]] base::Image image() { return accumulator_.image(); }
    /// The first surfaces of a view of one pixel (0: all).
    [[nodiscard]] std::shared_ptr<const layers::HostStack> pick(const Model& model, const base::View& view, int layers,
                                                                const goldfeather::EngineChoice& engine);
    /// See Renderer.
    void update(const Model& model, const csg::solid::SceneChange& change);
    [[nodiscard]] const PictureStatistics& statistics() const { return statistics_; }

  private:
    [[nodiscard]] bool holds(const Model& model, const goldfeather::EngineInfo& engine) const;
    void hold(const Model& model, const goldfeather::EngineInfo& engine);
    /// The first `max_layers` surfaces of the model that is held. `copy`: null, or where they are wanted in main
    /// memory, too.
    [[nodiscard]] layers::TextureStack peel(const base::View& view, int max_layers, goldfeather::WalkStats& stats,
                                            const std::stop_token& stop,
                                            std::shared_ptr<const layers::HostStack>* copy);
    npr::Style& style(const npr::StyleInfo& info);

    const gl::Functions& gl_;
    goldfeather::EngineSet engines_;
    layers::Upload upload_;
    npr::Accumulator accumulator_;
    std::map<const npr::StyleInfo*, std::unique_ptr<npr::Style>> styles_;  ///< Made when first used.
    std::shared_ptr<layers::SurfaceBuffers> table_;                        ///< Of the model that is held.
    std::shared_ptr<layers::SurfaceTable> rows_;         ///< What is in it, once the model has been edited.
    std::unique_ptr<goldfeather::PreparedScene> scene_;  ///< The same, for the engine that it is held for.
    const goldfeather::EngineInfo* engine_ = nullptr;
    std::uint64_t generation_ = 0;  ///< Of the model.
    PartMeshes meshes_;
    ShadowCasters shadows_;
    PictureStatistics statistics_;
};

}  // namespace ui
