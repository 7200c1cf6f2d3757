#include "ui/viewer/session.h"

#include <algorithm>
#include <stop_token>
#include <utility>

#include "ui/pipeline/picture/camera.h"
#include "ui/pipeline/sections.h"
#include "ui/viewer/open_source.h"

namespace ui {

namespace {

/// An evaluation that takes no longer is waited for while a value changes, so that something is to be seen; a longer
/// one is stopped.
constexpr double kQuickMilliseconds = 1000;
constexpr double kTurn = 15;  // Degrees per key press.
constexpr double kZoom = 1.25;

/// Where OpenSCAD keeps them.
std::filesystem::path parameter_file(const Source& source) {
    return source.text || source.nothing() ? std::filesystem::path()
                                           : std::filesystem::path(source.path).replace_extension(".json");
}

/// Turns by whole key presses, with orbit()'s rules.
void turn(base::Camera& camera, double about_x, double about_z) {
    constexpr double kPixelsPerDegree = 1 / 0.7;
    orbit(camera, {-about_z * kPixelsPerDegree, -about_x * kPixelsPerDegree});
}

}  // namespace

Session::Session(const WindowOptions& options, Evaluate evaluate, std::function<void()> wake)
    : camera_request_(options.camera),
      document_(options.source),
      view_(options.picture),
      customizer_(parameter_file(options.source)),
      evaluate_(std::move(evaluate)),
      watcher_(options.source.followed()),
      job_(std::move(wake)) {
    view_.picture.camera = choose_camera(camera_request_, {}, {});
    this->evaluate();
}

void Session::open(const std::filesystem::path& path) {
    document_ = Document(opened(path, document_.source()));
    customizer_ = Customizer(parameter_file(document_.source()));
    selection_.clear();
    text_ = {};
    watcher_ = FileWatcher(document_.source().followed());
    camera_request_.camera.reset();  // That was for another model.
    camera_placed_ = false;
    view_.picture.sections = {};
    shown_.open_form = false;
    evaluate();
}

void Session::evaluate() {
    customizing_ = false;
    if (document_.source().nothing()) {
        return;
    }
    job_.start(next_revision());
    began_ = std::chrono::steady_clock::now();
}

double Session::evaluating_for() const {
    return evaluating() ? std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count() : 0;
}

/// What lies over the picture, then what is selected, then what stands in the model's place, then what goes on behind.
void Session::close() {
    if (shown_.covered()) {
        shown_.uncover();
    } else if (!selection_.empty()) {
        selection_.clear();
    } else if (document_.source().explained) {
        document_.explain(std::nullopt);
        evaluate();
    } else if (evaluating()) {
        cancel();
    }
}

void Session::cancel() {
    job_.cancel();
    document_.cancel();
}

LatestJob<Revision>::Job Session::next_revision() const {
    return [evaluate = evaluate_, source = document_.source(), camera = scad_view(view_.picture.camera)](
               const std::stop_token& stop) { return evaluate(source, camera, stop); };
}

void Session::customize() {
    document_.customize(customizer_.definitions());
    if (document_.milliseconds() <= kQuickMilliseconds) {
        job_.start_after(next_revision());
    } else {
        job_.start(next_revision());
    }
    customizing_ = true;
    began_ = std::chrono::steady_clock::now();
}

bool Session::update(double now) {
    bool news = false;
    if (auto revision = job_.take()) {
        watcher_.watch(revision->files);
        if (revision->parameters) {
            customizer_.receive(*std::move(revision->parameters));
        }
        const bool other_model = revision->model != nullptr;
        document_.receive(std::move(*revision));
        if (other_model) {
            selection_.clear();  // It names leaves of the model before.
        }
        renew_text();
        place_camera();
        news = true;
    }
    const bool was_gone = document_.state() == DocumentState::Gone;
    if (watcher_.poll(now)) {
        evaluate();
        news = true;
    }
    document_.set_gone(watcher_.main_file_gone());
    return news || was_gone != (document_.state() == DocumentState::Gone);
}

void Session::select(std::vector<SelectedSurface> surfaces, const glm::dvec2& at) {
    selection_.take(std::move(surfaces), at);
    show_selected_text();
}

void Session::show_selected_text() {
    if (!selection_.empty() && !selection_.current().calls.empty() && selection_.current().calls[0].text.text) {
        text_ = selection_.current().calls[0].text;
    }
}

void Session::show_text(const TextPlace& place) {
    text_ = place;
    shown_.text = true;
    shown_.customizer = false;
}

void Session::renew_text() {
    const auto& sources = document_.sources();
    if (!sources || sources->size() == 0) {
        return;
    }
    for (std::uint32_t i = 0; i < sources->size(); ++i) {
        if (text_.text && (*sources)[i].name() == text_.text->name()) {
            const bool same = (*sources)[i].text() == text_.text->text();
            text_ = {sources->shared(i), same ? text_.range : csg::scad::SourceRange{}};
            return;
        }
    }
    text_ = {sources->shared(0), {}};
}

void Session::place_camera() {
    const auto& model = document_.model();
    if (camera_placed_ || !model || document_.state() == DocumentState::Failed) {
        return;
    }
    view_.picture.camera = choose_camera(camera_request_, document_.view(), model->box);
    view_.picture.sections = resolved(std::move(view_.picture.sections), model->box, view_.picture.camera);
    camera_placed_ = !model->empty();
}

/// Cut faces have the color of what was cut, where that is known of the parts.
void Session::cut(const npr::Sections& sections) {
    const auto& model = document_.model();
    view_.picture.sections = model ? resolved(sections, model->box, view_.picture.camera) : sections;
    if (!sections.cuts.empty() && document_.source().parts == csg::PartRule{}) {
        document_.divide({csg::PartRule::Kind::Color, 1, {}});
        evaluate();
    }
}

void Session::look_at(const glm::dvec3& point) {
    const glm::dvec3 back = glm::normalize(view_.picture.camera.eye() - view_.picture.camera.target);
    if (view_.picture.camera.projection == base::Projection::Perspective) {
        const double distance = glm::dot(view_.picture.camera.eye() - point, back);
        view_.picture.camera.distance = std::max(distance, 1e-6);
    }
    view_.picture.camera.target = point;
}

bool Session::perform(const Command& command) {
    if (const auto* action = std::get_if<Action>(&command)) {
        return act(*action);
    }
    if (const auto* style = std::get_if<SetStyle>(&command)) {
        view_.show_style(std::min(style->style, npr::styles().size() - 1));
    } else if (const auto* set = std::get_if<SetParameter>(&command)) {
        view_.picture.parameters.set(set->parameter, set->value);
    } else if (std::holds_alternative<ResetParameters>(command)) {
        view_.reset_parameters();
    } else if (const auto* scheme = std::get_if<SetScheme>(&command)) {
        view_.picture.scheme = npr::color_schemes()[std::min(scheme->scheme, npr::color_schemes().size() - 1)];
    } else if (const auto* transparency = std::get_if<SetTransparency>(&command)) {
        for (const npr::TransparencyInfo& model : npr::transparencies()) {
            if (model.model == transparency->transparency) {
                view_.picture.see_through_as(model);
            }
        }
    } else if (const auto* detail = std::get_if<SetTransparencyParameter>(&command)) {
        view_.picture.transparency_parameters.set(detail->parameter, detail->value);
    } else if (const auto* layers = std::get_if<SetLayers>(&command)) {
        view_.picture.layers = std::max(layers->layers, npr::kLayersOfStyle);
    } else if (const auto* samples = std::get_if<SetSamples>(&command)) {
        view_.picture.samples = static_cast<int>(npr::sample_offsets(samples->samples).size());
    } else if (const auto* sections = std::get_if<SetSections>(&command)) {
        cut(sections->sections);
    } else if (const auto* explain = std::get_if<Explain>(&command)) {
        document_.explain(explain->call);
        selection_.clear();
        evaluate();
    } else if (const auto* text = std::get_if<ShowText>(&command)) {
        show_text(text->place);
    } else if (const auto* step = std::get_if<StepSelection>(&command)) {
        selection_.step(step->by);
        show_selected_text();
    } else if (const auto* file = std::get_if<OpenFile>(&command)) {
        open(file->path);
    } else if (const auto* customized = std::get_if<SetCustomized>(&command)) {
        customizer_.set(customized->parameter, customized->value);
        customize();
    } else if (const auto* reset = std::get_if<ResetCustomized>(&command)) {
        customizer_.reset(reset->parameter);
        customize();
    } else if (const auto* used = std::get_if<UseParameterSet>(&command)) {
        customizer_.use(used->name);
        customize();
    } else if (const auto* saved = std::get_if<SaveParameterSet>(&command)) {
        customizer_.save(saved->name);
    } else if (const auto* deleted = std::get_if<DeleteParameterSet>(&command)) {
        customizer_.remove(deleted->name);
    } else if (const auto* engine = std::get_if<SetEngine>(&command)) {
        view_.picture.engine = engine->engine;
    } else {
        return false;
    }
    return true;
}

bool Session::act(Action action) {
    base::Camera& camera = view_.picture.camera;
    switch (action) {
        case Action::Open:
            shown_.open_form = true;
            break;
        case Action::Reload:
            evaluate();
            break;
        case Action::SavePicture:
            shown_.save_form = true;
            break;
        case Action::Export:
            shown_.export_form = true;
            break;
        case Action::ViewAll:
            if (document_.model()) {
                base::view_all(camera, document_.model()->box.lo, document_.model()->box.hi, true);
            }
            break;
        case Action::ResetView:
            camera = base::Camera{};
            break;
        case Action::LookAtOrigin:
            camera.target = glm::dvec3(0);
            break;
        case Action::Top:
        case Action::Bottom:
        case Action::Left:
        case Action::Right:
        case Action::Front:
        case Action::Back:
        case Action::Diagonal:
            camera.rotation = *looks_from(action);
            break;
        case Action::ToggleProjection:
            toggle_projection(camera);
            break;
        case Action::ZoomIn:
            zoom(camera, 1 / kZoom, camera.target);
            break;
        case Action::ZoomOut:
            zoom(camera, kZoom, camera.target);
            break;
        case Action::TurnLeft:
            turn(camera, 0, kTurn);
            break;
        case Action::TurnRight:
            turn(camera, 0, -kTurn);
            break;
        case Action::TurnUp:
            turn(camera, kTurn, 0);
            break;
        case Action::TurnDown:
            turn(camera, -kTurn, 0);
            break;
        case Action::NextStyle:
            step_style(1);
            break;
        case Action::PreviousStyle:
            step_style(-1);
            break;
        case Action::MoreLayers:
            step_layers(1);
            break;
        case Action::FewerLayers:
            step_layers(-1);
            break;
        case Action::ToggleAxes:
            shown_.axes = !shown_.axes;
            break;
        case Action::TogglePanel:
            shown_.panel = !shown_.panel;
            break;
        case Action::ToggleText:
            shown_.text = !shown_.text;
            shown_.customizer = false;
            break;
        case Action::ToggleCustomizer:
            shown_.customizer = !shown_.customizer;
            shown_.text = false;
            break;
        case Action::ToggleConsole:
            shown_.console = !shown_.console;
            break;
        case Action::ClearConsole:
            document_.clear_messages();
            break;
        case Action::Help:
            shown_.help = !shown_.help;
            break;
        case Action::Cancel:
            cancel();
            break;
        case Action::Close:
            close();
            break;
        case Action::Quit:
        case Action::CopyConsole:
        case Action::CopyCamera:
            return false;
    }
    return true;
}

void Session::see_layers(const Model& model, int layers) {
    const int before = std::exchange(layers_of_, model.generation) == model.generation ? layer_count_ : 1;
    layer_count_ = std::max(before, layers);
}

void Session::step_style(int by) {
    const std::size_t count = npr::styles().size();
    view_.show_style((view_.style() + count + static_cast<std::size_t>(by + static_cast<int>(count))) % count);
}

void Session::step_layers(int by) {
    // 1 … n, then all (0); from "what the style needs" to the nearer end.
    const int all = layer_count_ + 1;
    const int now = view_.picture.layers < 0    ? (by > 0 ? 0 : all + 1)
                    : view_.picture.layers == 0 ? all
                                                : view_.picture.layers;
    const int next = std::clamp(now + by, 1, all);
    view_.picture.layers = next >= all ? 0 : next;
}

}  // namespace ui
