#include "ui/pipeline/picture/cpu_renderer.h"

#include "goldfeather/smooth_facets.h"
#include "goldfeather/surface_table.h"
#include "npr/shine/view_dependent_settings.h"
#include "npr/smooth_shading.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

void CpuRenderer::hold(const Model& model, const goldfeather::EngineInfo& engine) {
    if (scene_ && generation_ == model.generation && engine_ == &engine) {
        return;
    }
    scene_.reset();
    table_ = goldfeather::surface_table(model.scene, model.geometry);
    scene_ = engines_.prepare({model.scene, model.geometry, model.products}, engine);
    engine_ = &engine;
    generation_ = model.generation;
    edited_ = false;
    facets_.forget();
}

void CpuRenderer::update(const Model& model, const csg::solid::SceneChange& change) {
    sorted_.reset();
    meshes_.forget();
    shadows_.forget();
    if (!scene_ || generation_ != model.generation) {
        return;
    }
    if ((engine_->capabilities.needs_products && !model.over_budget.empty()) || !scene_->update(change)) {
        scene_.reset();  // It is made anew for the next picture.
        return;
    }
    if (stack_.host) {
        stack_.host->table.reset();  // Nobody else holds the table then.
    }
    edited_ = true;
    facets_.changed(change);
    goldfeather::update(*table_, model.scene, model.geometry, change);
}

const npr::Paint& CpuRenderer::paint(const npr::StyleInfo& style) {
    npr::Paint& made = styles_[&style];
    if (!made) {
        made = style.make_paint();
    }
    return made;
}

void CpuRenderer::draw_sample(const Model& model, const npr::Picture& picture, const goldfeather::EngineInfo& engine,
                              int sample, const std::stop_token& stop) {
    begin(sample);
    Stopwatch watch;
    hold(model, engine);
    if (npr::shades_smoothly(picture) && table_->smooth.starts.empty()) {
        table_->smooth = edited_ ? facets_.facets(model.geometry) : goldfeather::smooth_facets(model.geometry);
    }
    statistics_.upload_ms += watch.lap();
    const int layers = layers_to_peel(picture, model);
    paint_sample(
        model, picture, sample,
        [&](const base::View& view) -> const layers::HostStack& {
            stack_ = {};  // Its memory is used again.
            stack_ = scene_->draw(view, layers, statistics_.walk, stop);
            stack_.host->table = table_;
            return *stack_.host;
        },
        stop);
}

void CpuRenderer::draw_sample(const Model& model, const npr::Picture& picture, int sample, const Peel& peel,
                              const std::stop_token& stop) {
    begin(sample);
    const auto table = goldfeather::surface_table(model.scene, model.geometry);
    if (npr::shades_smoothly(picture)) {
        table->smooth = goldfeather::smooth_facets(model.geometry);
    }
    layers::HostStack stack;
    paint_sample(
        model, picture, sample,
        [&](const base::View& view) -> const layers::HostStack& {
            stack = *peel(view, layers_to_peel(picture, model));
            stack.table = table;
            return stack;
        },
        stop);
}

void CpuRenderer::begin(int sample) {
    if (sample == 0) {
        statistics_ = {};
    }
}

const layers::HostStack& CpuRenderer::reveal(const npr::Picture& picture, const layers::HostStack& stack, int sample) {
    if (sample == 0) {
        statistics_.revealed = npr::layers_to_peel_away(picture, stack);
    }
    npr::peel_away(picture, stack, statistics_.revealed.layers, revealed_);
    return revealed_;
}

void CpuRenderer::paint_sample(const Model& model, const npr::Picture& picture, int sample,
                               const std::function<const layers::HostStack&(const base::View&)>& peel,
                               const std::stop_token& stop) {
    Stopwatch watch;
    const layers::HostStack* drawn = nullptr;
    const npr::CpuSubject subject{
        model.geometry.box.lo, model.geometry.box.hi,
        [&](const base::View& view) -> const layers::HostStack& {
            statistics_.style_ms += watch.lap();
            const layers::HostStack& stack = peel(view);
            statistics_.peel_ms += watch.lap();
            ++statistics_.samples;
            drawn = picture.reveal.empty() ? &stack : &reveal(picture, stack, sample);
            return *drawn;
        },
        npr::shines_by_vertex(picture) ? &meshes_.of(model, picture.scheme, stop) : nullptr,
        [&](const base::View& view) { return shadows_.of(model).shadows(view, *drawn, stop); }};
    const auto in_parts = [&](const npr::CpuFrame& frame) { parts_(frame); };
    accumulator_.paint_sample(picture.part_styles.empty() ? paint(*picture.style) : npr::Paint(in_parts), picture,
                              static_cast<std::size_t>(sample), subject, stop);
    statistics_.style_ms += watch.lap();
}

void CpuRenderer::draw_sorted(const Model& model, const npr::Picture& picture, int sample,
                              const std::stop_token& stop) {
    begin(sample);
    Stopwatch watch;
    if (!sorted_ || sorted_generation_ != model.generation || !(sorted_scheme_ == picture.scheme)) {
        sorted_ = std::make_unique<npr::SortedPainter>(colored_mesh(model, picture.scheme, stop));
        sorted_generation_ = model.generation;
        sorted_scheme_ = picture.scheme;
        sorted_table_ = goldfeather::surface_table(model.scene, model.geometry);
        statistics_.upload_ms += watch.lap();
    }
    const bool styled = sorts_layers(picture);
    const layers::HostStack none;  // It is not looked at.
    const layers::HostStack* drawn = &none;
    accumulator_.paint_sample(
        [&](const npr::CpuFrame& frame) {
            styled ? sorted_->paint_styled(frame, sample == 0) : sorted_->paint(frame, sample == 0);
        },
        picture, static_cast<std::size_t>(sample),
        {model.geometry.box.lo, model.geometry.box.hi,
         [&](const base::View& view) -> const layers::HostStack& {
             if (!styled) {
                 return none;
             }
             const layers::HostStack& all = sorted_->layers(view, sorted_table_);
             drawn = picture.reveal.empty() ? &all : &reveal(picture, all, sample);
             return *drawn;
         },
         nullptr, [&](const base::View& view) { return shadows_.of(model).shadows(view, *drawn, stop); }},
        stop);
    ++statistics_.samples;
    statistics_.sorts = sorted_->counts();
    statistics_.sorted_triangles = sorted_->mesh().triangles.size();
    statistics_.style_ms += watch.lap();
}

std::shared_ptr<const layers::HostStack> CpuRenderer::pick(const Model& model, const base::View& view, int layers,
                                                           const goldfeather::EngineInfo& engine) {
    hold(model, engine);
    goldfeather::WalkStats ignored;
    return scene_->draw(view, layers, ignored).host;
}

}  // namespace ui
