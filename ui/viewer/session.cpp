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

/// Where OpenSCAD keeps them.
std::filesystem::path parameter_file(const Source& source) {
    return source.text || source.nothing() ? std::filesystem::path()
                                           : std::filesystem::path(source.path).replace_extension(".json");
}

/// Of sections that miss the model, or leave nothing of it.
void warn(Document& document, const Model& model, const npr::Sections& sections) {
    for (const std::string& text : section_warnings(model, sections)) {
        document.add_message(LineKind::Warning, "WARNING: " + text);
    }
}

}  // namespace

Session::Session(const WindowOptions& options, Evaluate evaluate, std::function<void()> wake)
    : camera_request_(options.camera),
      document_(options.source),
      view_(options.picture),
      customizer_(parameter_file(options.source)),
      settings_file_(options.settings),
      settings_(read_settings(options.settings)),
      evaluate_(std::move(evaluate)),
      watcher_(options.source.followed()),
      dynamics_(wake),
      find_ways_(make_find_ways()),
      moving_(wake),
      job_(std::move(wake)) {
    editing_ = Editing(document_.source(), settings_file_);
    shown_.recovery_form = editing_.left().has_value();
    view_.picture.camera = choose_camera(camera_request_, {}, {});
    const csg::PartRule& parts = options.source.parts;
    const bool of_sections = !options.source.sections.cuts.empty() && parts.kind == csg::PartRule::Kind::Color;
    parts_given_ = parts != csg::PartRule{} && !of_sections && parts != parts_of_labels(options.glyphs.annotations);
    if (options.glyphs.any()) {
        shown_.dynamics = true;
        set_glyphs(options.glyphs);
    }
    this->evaluate();
}

void Session::open(const std::filesystem::path& path) {
    document_ = Document(opened(path, document_.source()));
    customizer_ = Customizer(parameter_file(document_.source()));
    editing_ = Editing(document_.source(), settings_file_);
    clear_selection();
    take_way(std::nullopt);
    moving_.cancel();
    held_ = {};
    select_next_.reset();
    label_to_come_.reset();
    dynamics_.cancel();
    dynamics_.set({});
    document_.depict(nullptr);
    annotations_.reset();
    animation_ = {};
    text_ = {};
    watcher_ = FileWatcher(document_.source().followed());
    camera_request_.camera.reset();  // That was for another model.
    camera_placed_ = false;
    view_.picture.sections = {};
    shown_.open_form = false;
    shown_.recovery_form = editing_.left().has_value();
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

std::optional<int> Session::evaluating_for() const {
    using std::chrono::duration_cast, std::chrono::seconds;
    const auto passed = std::chrono::steady_clock::now() - began_;
    return evaluating() ? std::optional(static_cast<int>(duration_cast<seconds>(passed).count())) : std::nullopt;
}

/// What lies over the picture, then what is selected, then what stands in the model's place, then what goes on behind.
void Session::close() {
    if (shown_.covered()) {
        shown_.uncover();
    } else if (moving_.busy()) {
        moving_.cancel();
        held_ = {};
    } else if (ways_) {
        take_way(std::nullopt);
    } else if (selected_ != csg::kNoOccurrence || !selection_.empty()) {
        clear_selection();
    } else if (document_.source().explained) {
        document_.explain(std::nullopt);
        evaluate();
    } else if (document_.source().before) {
        document_.compare(std::nullopt);
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
    follow_soon();
}

void Session::follow_soon() {
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
    now_ = now;
    if (auto revision = job_.take()) {
        watcher_.watch(revision->files);
        if (revision->parameters) {
            customizer_.receive(*std::move(revision->parameters));
        }
        const bool other_model = revision->model != nullptr;
        const std::optional<SelectNext> kept = other_model ? std::optional(same_as_now()) : std::nullopt;
        document_.receive(std::move(*revision));
        if (other_model) {
            held_ = {};
            // What is selected names leaves of the model before.
            select_again(select_next_ ? *std::exchange(select_next_, {}) : *kept);
        }
        renew_text();
        place_camera();
        if (other_model) {
            follow_motion();
        }
        if (document_.model()) {
            warn(document_, *document_.model(), view_.picture.sections);
        }
        news = true;
    }
    const bool was_gone = document_.state() == DocumentState::Gone;
    if (auto answer = moving_.take()) {
        take_ways(*std::move(answer));
        news = true;
    }
    if (dynamics_.update()) {
        follow_motion();
        news = true;
    }
    editing_.keep(now);
    if (watcher_.poll(now)) {
        look_at_disk();
        evaluate();
        news = true;
    }
    if (animation_.plays() && !evaluating() && animation_.advance(now)) {
        run_animation();
        news = true;
    }
    document_.set_gone(watcher_.main_file_gone());
    return news || was_gone != (document_.state() == DocumentState::Gone);
}

void Session::select(std::vector<SelectedSurface> surfaces, const glm::dvec2& at) {
    selection_.take(std::move(surfaces), at);
    mark_selected();
    show_selected_text();
}

void Session::mark_selected() {
    if (selection_.empty()) {
        mark(csg::kNoOccurrence, {});
        return;
    }
    const SelectedSurface& current = selection_.current();
    mark(current.surface.occurrence, current.calls.empty() ? "" : current.calls[0].place);
}

void Session::mark(csg::OccurrenceId occurrence, const std::string& place) {
    selected_ = occurrence;
    selected_place_ = place;
    ghost_ = document_.model() ? ghost_of(*document_.model(), occurrence) : Ghost{};
}

void Session::clear_selection() {
    selection_.clear();
    mark(csg::kNoOccurrence, {});
}

void Session::run_animation() {
    document_.set_time(animation_.time());
    job_.start_after(next_revision());
    customizing_ = true;
    began_ = std::chrono::steady_clock::now();
}

void Session::show_selected_text() {
    if (!selection_.empty() && !selection_.current().calls.empty() && selection_.current().calls[0].text.text) {
        text_ = selection_.current().calls[0].text;
    }
}

void Session::show_text(const TextPlace& place) {
    text_ = place;
    shown_.text = true;
    shown_.customizer = shown_.tree = false;
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
    const bool missed = model && !section_warnings(*model, view_.picture.sections).empty();
    view_.picture.sections = model ? resolved(sections, model->box, view_.picture.camera) : sections;
    if (model && !missed) {
        warn(document_, *model, view_.picture.sections);
    }
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

void Session::see_layers(const Model& model, int layers) {
    const int before = std::exchange(layers_of_, model.generation) == model.generation ? layer_count_ : 1;
    layer_count_ = std::max(before, layers);
}

}  // namespace ui
