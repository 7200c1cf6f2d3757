#include "ui/pipeline/picture/renderer.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "ui/pipeline/picture/sorted_mesh.h"
#include "ui/pipeline/stopwatch.h"

namespace ui {

Renderer::Renderer(const gl::Context& context, const goldfeather::EngineOptions& engine, Painter painter)
    : wanted_(engine), painter_(painter), context_(&context), cpu_(engine.minimal_fraction) {}

Renderer::Renderer(const goldfeather::EngineOptions& engine, Painter painter)
    : wanted_(engine), painter_(painter), cpu_(engine.minimal_fraction) {}

GlRenderer& Renderer::with_opengl() {
    if (context_ == nullptr) {
        own_context_ = gl::create_context(gl::ContextKind::Auto);
        context_ = own_context_.get();
    }
    if (!gl_) {
        gl_ = std::make_unique<GlRenderer>(*context_, wanted_.memory_budget, wanted_.minimal_fraction);
    }
    return *gl_;
}

bool Renderer::choose_cpu(const Model& model, const goldfeather::EngineInfo* engine, int layers) {
    const bool software = context_ == nullptr || context_->software();
    choice_ = goldfeather::choose_engine(engine != nullptr ? engine : wanted_.engine,
                                         engine_conditions(model, software, layers));
    const bool possible = !choice_.engine->capabilities.needs_opengl;
    if (painter_ == Painter::Cpu && !possible) {
        throw std::runtime_error(fmt::format("the engine {} needs OpenGL", choice_.engine->name));
    }
    return possible && painter_ != Painter::OpenGl && software;
}

void Renderer::draw_sample(const Model& model, const PictureRequest& request, int sample, const std::stop_token& stop) {
    const npr::Picture picture = is_flat_picture(model, request) ? flat_picture(request, true) : npr::Picture(request);
    if (sample == 0) {
        peeled_on_cpu_ = choose_cpu(model, request.engine, layers_to_peel(picture, model));
        on_cpu_ = peeled_on_cpu_ || !picture.part_styles.empty() || !picture.reveal.empty() || draws_sorted(picture);
    }
    if (draws_sorted(picture)) {
        cpu_.draw_sorted(model, picture, sample, stop);
        statistics_ = cpu_.statistics();
        statistics_.engine = choice_;
    } else if (peeled_on_cpu_) {
        cpu_.draw_sample(model, picture, *choice_.engine, sample, stop);
        statistics_ = cpu_.statistics();
        statistics_.engine = choice_;
    } else if (on_cpu_) {
        cpu_.draw_sample(
            model, picture, sample,
            [&](const base::View& view, int layers) { return with_opengl().pick(model, view, layers, choice_); }, stop);
        statistics_ = cpu_.statistics();
        statistics_.engine = choice_;
    } else {
        with_opengl().draw_sample(model, picture, choice_, sample, stop);
        statistics_ = gl_->statistics();
        statistics_.opengl = true;
    }
}

void Renderer::update(const Model& model, const csg::solid::SceneChange& change) {
    cpu_.update(model, change);
    if (gl_) {
        gl_->update(model, change);
    }
}

base::Image Renderer::image() {
    return on_cpu_ ? cpu_.image() : gl_->image();
}

std::shared_ptr<const layers::HostStack> Renderer::peel(const Model& model, const base::View& view, int layers) {
    const goldfeather::EngineChoice of_picture = choice_;
    const bool on_cpu = choose_cpu(model, nullptr, layers);
    const goldfeather::EngineChoice choice = std::exchange(choice_, of_picture);
    return on_cpu ? cpu_.pick(model, view, layers, *choice.engine) : with_opengl().pick(model, view, layers, choice);
}

std::vector<PickedSurface> Renderer::pick(const Model& model, const base::Camera& camera, int layers) {
    const base::View view(camera, {1, 1}, model.geometry.box.lo, model.geometry.box.hi);
    return picked(model, view, *peel(model, view, layers));
}

base::Image Renderer::render(const Model& model, const PictureRequest& request, const std::stop_token& stop) {
    for (std::size_t sample = 0; sample < npr::sample_offsets(request.samples).size(); ++sample) {
        draw_sample(model, request, static_cast<int>(sample), stop);
    }
    Stopwatch watch;
    base::Image result = image();
    statistics_.read_ms = watch.lap();
    return result;
}

}  // namespace ui
