#include "ui/pipeline/picture/cpu_renderer.h"

#include "goldfeather/surface_table.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

void CpuRenderer::hold(const Model& model) {
    if (model_ && generation_ == model.generation) {
        return;
    }
    model_.reset();
    model_ = std::make_unique<Held>(Held{goldfeather::ListsModel(model.scene, model.geometry),
                                         goldfeather::surface_table(model.scene, model.geometry)});
    generation_ = model.generation;
}

const npr::Paint& CpuRenderer::paint(const npr::StyleInfo& style) {
    npr::Paint& made = styles_[&style];
    if (!made) {
        made = style.make_paint();
    }
    return made;
}

void CpuRenderer::draw_sample(const Model& model, const npr::Picture& picture, int sample,
                              const std::stop_token& stop) {
    if (sample == 0) {
        statistics_ = {};
    }
    Stopwatch watch;
    hold(model);
    statistics_.upload_ms += watch.lap();
    layers_.table = model_->table;
    const int layers = layers_to_peel(picture, model);
    const npr::CpuSubject subject{model.geometry.box.lo, model.geometry.box.hi,
                                  [&](const base::View& view) -> const layers::HostStack& {
                                      statistics_.style_ms += watch.lap();
                                      goldfeather::ListsStats stats;
                                      goldfeather::peel_lists(model_->lists, view, layers, 0, layers_, stats, stop);
                                      statistics_.peel_ms += watch.lap();
                                      ++statistics_.samples;
                                      goldfeather::add(statistics_.walk, stats);
                                      layers::leave_out_sparse_layers(layers_, minimal_fraction_);
                                      return layers_;
                                  }};
    accumulator_.paint_sample(paint(*picture.style), picture, static_cast<std::size_t>(sample), subject, stop);
    statistics_.style_ms += watch.lap();
}

std::optional<glm::dvec3> CpuRenderer::pick(const Model& model, const base::Camera& camera) {
    hold(model);
    const base::View view(camera, {1, 1}, model.geometry.box.lo, model.geometry.box.hi);
    layers::HostStack layers;
    goldfeather::ListsStats ignored;
    goldfeather::peel_lists(model_->lists, view, 1, 1, layers, ignored);
    const float depth = layers.planes.front().depth.front();
    if (!(depth > 0)) {
        return std::nullopt;
    }
    const base::View::Ray ray = view.ray(0, 0);
    return ray.origin + view.distance(depth) * ray.direction;
}

}  // namespace ui
