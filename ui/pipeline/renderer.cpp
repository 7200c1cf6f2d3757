#include "ui/pipeline/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "ui/pipeline/stopwatch.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

template <typename Named>
[[noreturn]] void throw_unknown(std::string_view what, std::string_view name, std::span<const Named> known) {
    std::vector<std::string> names;
    for (const Named& each : known) {
        names.emplace_back(each.name);
    }
    throw std::runtime_error(fmt::format(
        "no {} \"{}\".{}", what, name, suggestion(name, names, fmt::format(" There are {}.", fmt::join(names, ", ")))));
}

const npr::StyleInfo& style_of(const PictureRequest& request) {
    const npr::StyleInfo* info = npr::find_style(request.style);
    if (info == nullptr) {
        throw_unknown("style", request.style, npr::styles());
    }
    return *info;
}

const npr::ColorScheme& scheme_of(const PictureRequest& request) {
    const npr::ColorScheme* scheme = npr::find_color_scheme(request.scheme);
    if (scheme == nullptr) {
        throw_unknown("color scheme", request.scheme, npr::color_schemes());
    }
    return *scheme;
}

npr::Parameters parameters_of(const PictureRequest& request) {
    npr::Parameters parameters(style_of(request).parameters());
    for (const auto& [name, value] : request.settings) {
        try {
            parameters.set(name, value);
        } catch (const std::invalid_argument& error) {
            throw std::runtime_error(fmt::format("style {}: {}", request.style, error.what()));
        }
    }
    return parameters;
}

/// Does anything show what is behind it?
bool translucent(const csg::Scene& scene) {
    return std::any_of(scene.parts.begin(), scene.parts.end(),
                       [](const csg::Part& part) { return part.kind != csg::PartKind::Solid; }) ||
           std::any_of(scene.leaves.begin(), scene.leaves.end(),
                       [](const csg::LeafInstance& leaf) { return leaf.color.given() && leaf.color.a < 1; });
}

}  // namespace

void check_picture(const PictureRequest& request) {
    (void)scheme_of(request);
    (void)parameters_of(request);
}

Renderer::Renderer(const gl::Context& context, std::optional<goldfeather::EngineKind> engine)
    : gl_(context.functions()), software_(context.software()), wanted_(engine), peeler_(gl_), accumulator_(gl_) {}

void Renderer::hold(const Model& model) {
    if (model_ && generation_ == model.generation) {
        return;
    }
    choice_ = goldfeather::choose_engine(wanted_, {software_, !model.over_budget.empty()});
    if (choice_.engine == goldfeather::EngineKind::Goldfeather && !model.over_budget.empty()) {
        throw ModelError(model.over_budget);
    }
    model_.reset();  // Before the next is made: the two need not fit together.
    model_ = std::make_unique<peel::PeelModel>(gl_, model.scene, model.geometry, model.products, choice_.engine);
    generation_ = model.generation;
    translucent_ = translucent(model.scene);
}

npr::Style& Renderer::style(const npr::StyleInfo& info) {
    std::unique_ptr<npr::Style>& made = styles_[std::string(info.name)];
    if (!made) {
        made = info.make(gl_);
    }
    return *made;
}

void Renderer::draw_sample(const Model& model, const PictureRequest& request, int sample) {
    const npr::Parameters parameters = parameters_of(request);
    const npr::ColorScheme& scheme = scheme_of(request);
    if (sample == 0) {
        statistics_ = {};
    }
    Stopwatch watch;
    const bool held = model_ && generation_ == model.generation;
    hold(model);
    npr::Style& style = this->style(style_of(request));
    gl_.Finish();
    const double upload = watch.lap();
    statistics_.upload_ms += held ? 0 : upload;

    const int layers = request.layers >= 0 ? request.layers : style.layers_needed(parameters, translucent_);
    const npr::Picture picture{request.camera, request.size, model.geometry.box.lo,          model.geometry.box.hi,
                               parameters,     scheme,       request.transparent_background, request.samples};
    peeler_.give_back(
        accumulator_.draw_sample(style, picture, static_cast<std::size_t>(sample), [&](const gl::View& view) {
            (void)watch.lap();
            peel::LayerStack stack =
                peeler_.peel(view, *model_, layers == 0 ? peel::kAllLayers : layers, statistics_.walk);
            gl_.Finish();
            statistics_.peel_ms += watch.lap();
            ++statistics_.samples;
            return stack;
        }));
    gl_.Finish();
    statistics_.style_ms += watch.lap();
    statistics_.engine = choice_;
}

void Renderer::accumulate(const Model& model, const PictureRequest& request) {
    for (std::size_t sample = 0; sample < npr::sample_offsets(request.samples).size(); ++sample) {
        draw_sample(model, request, static_cast<int>(sample));
    }
}

std::optional<glm::dvec3> Renderer::pick(const Model& model, const gl::Camera& camera) {
    hold(model);
    const gl::View view(camera, {1, 1}, model.geometry.box.lo, model.geometry.box.hi);
    peel::WalkStats ignored;
    const peel::LayerStack stack = peeler_.peel(view, *model_, 1, ignored);
    const float depth = peel::read_back(gl_, stack).at(0, 0, 0).depth;
    if (!(depth > 0)) {
        return std::nullopt;
    }
    const gl::View::Ray ray = view.ray(0, 0);
    return ray.origin + view.distance(depth) * ray.direction;
}

gl::Image Renderer::render(const Model& model, const PictureRequest& request) {
    accumulate(model, request);
    Stopwatch watch;
    gl::Image image = accumulator_.image();
    statistics_.read_ms = watch.lap();
    return image;
}

}  // namespace ui
