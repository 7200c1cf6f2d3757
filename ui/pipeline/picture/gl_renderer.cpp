#include "ui/pipeline/picture/gl_renderer.h"

#include "ui/pipeline/stopwatch.h"

namespace ui {

GlRenderer::GlRenderer(const gl::Context& context, std::size_t memory_budget, double minimal_fraction)
    : gl_(context.functions()), peeler_(gl_, memory_budget, minimal_fraction), accumulator_(gl_) {}

bool GlRenderer::holds(const Model& model, goldfeather::EngineKind engine) const {
    return model_ && generation_ == model.generation && model_->engine == engine;
}

void GlRenderer::hold(const Model& model, goldfeather::EngineKind engine) {
    if (holds(model, engine)) {
        return;
    }
    if (goldfeather::needs_products(engine) && !model.over_budget.empty()) {
        throw ModelError(model.over_budget);
    }
    model_.reset();  // Before the next is made: the two need not fit together.
    model_ = std::make_unique<peel::PeelModel>(gl_, model.scene, model.geometry, model.products, engine);
    generation_ = model.generation;
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
    const bool held = holds(model, engine.engine);
    hold(model, engine.engine);
    npr::Style& style = this->style(*picture.style);
    gl_.Finish();
    const double upload = watch.lap();
    statistics_.upload_ms += held ? 0 : upload;

    const int layers = layers_to_peel(picture, model);
    const npr::Subject subject{model.geometry.box.lo, model.geometry.box.hi, [&](const base::View& view) {
                                   (void)watch.lap();
                                   layers::TextureStack stack = peeler_.peel(
                                       view, *model_, layers == 0 ? peel::kAllLayers : layers, statistics_.walk, stop);
                                   gl_.Finish();
                                   statistics_.peel_ms += watch.lap();
                                   ++statistics_.samples;
                                   return stack;
                               }};
    peeler_.give_back(accumulator_.draw_sample(style, picture, static_cast<std::size_t>(sample), subject, stop));
    gl_.Finish();
    statistics_.style_ms += watch.lap();
    const std::string& fallback = statistics_.walk.fallback;
    statistics_.engine =
        fallback.empty() ? engine : goldfeather::EngineChoice{goldfeather::EngineKind::ListsCpu, fallback};
}

std::optional<glm::dvec3> GlRenderer::pick(const Model& model, const base::Camera& camera,
                                           const goldfeather::EngineChoice& engine) {
    // Whatever engine the model is held for does.
    hold(model, model_ && generation_ == model.generation ? model_->engine : engine.engine);
    const base::View view(camera, {1, 1}, model.geometry.box.lo, model.geometry.box.hi);
    peel::WalkStats ignored;
    const layers::TextureStack stack = peeler_.peel(view, *model_, 1, ignored);
    const float depth = layers::read_back(gl_, stack).at(0, 0, 0).depth;
    if (!(depth > 0)) {
        return std::nullopt;
    }
    const base::View::Ray ray = view.ray(0, 0);
    return ray.origin + view.distance(depth) * ray.direction;
}

}  // namespace ui
