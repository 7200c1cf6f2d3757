#include "ui/pipeline/picture/gl_renderer.h"

#include "goldfeather/smooth_facets.h"
#include "goldfeather/surface_table.h"
#include "npr/shine/view_dependent_settings.h"
#include "npr/smooth_shading.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

GlRenderer::GlRenderer(const gl::Context& context, std::size_t memory_budget, double minimal_fraction)
    : gl_(context.functions()), engines_({&gl_, memory_budget, minimal_fraction}), upload_(gl_), accumulator_(gl_) {}

bool GlRenderer::holds(const Model& model, const goldfeather::EngineInfo& engine) const {
    return scene_ && generation_ == model.generation && engine_ == &engine;
}

void GlRenderer::hold(const Model& model, const goldfeather::EngineInfo& engine) {
    if (holds(model, engine)) {
        return;
    }
    if (engine.capabilities.needs_products && !model.over_budget.empty()) {
        throw ModelError(model.over_budget);
    }
    scene_.reset();  // Before the next is made: the two need not fit together.
    table_.reset();
    rows_.reset();
    table_ = std::make_shared<layers::SurfaceBuffers>(gl_, *goldfeather::surface_table(model.scene, model.geometry));
    scene_ = engines_.prepare({model.scene, model.geometry, model.products}, engine);
    engine_ = &engine;
    generation_ = model.generation;
}

void GlRenderer::update(const Model& model, const csg::solid::SceneChange& change) {
    meshes_.forget();
    shadows_.forget();
    if (!scene_ || generation_ != model.generation) {
        return;
    }
    if ((engine_->capabilities.needs_products && !model.over_budget.empty()) || !scene_->update(change)) {
        scene_.reset();  // It is made anew for the next picture.
        return;
    }
    const bool all = !rows_ || change.structure || change.center || change.all_planes;
    if (!rows_) {
        rows_ = goldfeather::surface_table(model.scene, model.geometry);
    } else {
        goldfeather::update(*rows_, model.scene, model.geometry, change);
    }
    if (all) {
        table_ = std::make_shared<layers::SurfaceBuffers>(gl_, *rows_);
    } else {
        table_->update(*rows_, change.planes);
    }
}

layers::TextureStack GlRenderer::peel(const base::View& view, int max_layers, goldfeather::WalkStats& stats,
                                      const std::stop_token& stop, std::shared_ptr<const layers::HostStack>* copy) {
    const layers::Stack drawn = scene_->draw(view, max_layers, stats, stop);
    if (copy != nullptr) {
        *copy = layers::in_main_memory(gl_, drawn);
    }
    layers::TextureStack stack = upload_.textures(drawn);
    stack.table = table_;
    return stack;
}

npr::Style& GlRenderer::style(const npr::StyleInfo& info) {
    std::unique_ptr<npr::Style>& made = styles_[&info];
    if (!made) {
        made = info.make(gl_);
    }
    return *made;
}

void GlRenderer::draw_sample(const Model& model, const npr::Picture& picture, const goldfeather::EngineChoice& engine,
                             int sample, const std::stop_token& stop) {
    if (sample == 0) {
        statistics_ = {};
    }
    Stopwatch watch;
    const bool held = holds(model, *engine.engine);
    hold(model, *engine.engine);
    if (npr::shades_smoothly(picture) && !table_->knows_facets) {
        table_->take(goldfeather::smooth_facets(model.geometry));
    }
    npr::Style& style = this->style(*picture.style);
    gl_.Finish();
    const double upload = watch.lap();
    statistics_.upload_ms += held ? 0 : upload;

    const int layers = layers_to_peel(picture, model);
    std::shared_ptr<const layers::HostStack> drawn;  // Where shadows are asked for.
    const npr::Subject subject{model.geometry.box.lo, model.geometry.box.hi,
                               [&](const base::View& view) {
                                   (void)watch.lap();
                                   layers::TextureStack stack = peel(view, layers, statistics_.walk, stop,
                                                                     npr::casts_shadows(picture) ? &drawn : nullptr);
                                   gl_.Finish();
                                   statistics_.peel_ms += watch.lap();
                                   ++statistics_.samples;
                                   return stack;
                               },
                               npr::shines_by_vertex(picture) ? &meshes_.of(model, picture.scheme, stop) : nullptr,
                               [&](const base::View& view) { return shadows_.of(model).shadows(view, *drawn, stop); }};
    upload_.give_back(accumulator_.draw_sample(style, picture, static_cast<std::size_t>(sample), subject, stop));
    gl_.Finish();
    statistics_.style_ms += watch.lap();
    const std::string& fallback = statistics_.walk.fallback;
    statistics_.engine =
        fallback.empty() ? engine : goldfeather::EngineChoice{&goldfeather::fallback_engine(), fallback};
}

std::shared_ptr<const layers::HostStack> GlRenderer::pick(const Model& model, const base::View& view, int layers,
                                                          const goldfeather::EngineChoice& engine) {
    // Whatever engine the model is held for does, as long as the first layer is all that is wanted.
    hold(model, layers == 1 && scene_ && generation_ == model.generation ? *engine_ : *engine.engine);
    goldfeather::WalkStats ignored;
    return layers::in_main_memory(gl_, scene_->draw(view, layers, ignored));
}

}  // namespace ui
