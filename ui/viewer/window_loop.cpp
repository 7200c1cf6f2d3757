#include "ui/viewer/window_loop.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "ui/pipeline/picture/pick.h"
#include "ui/viewer/camera_control.h"
#include "ui/viewer/editor.h"
#include "ui/viewer/open_source.h"

namespace ui {

namespace {

constexpr glm::ivec2 kWindowSize{1280, 800};
constexpr double kPollSeconds = 0.2;
/// Between frames while something goes on by itself.
constexpr double kAdvanceSeconds = 1.0 / 60;
/// How long the end waits for the picture that is being drawn and was stopped.
constexpr double kLastPictureSeconds = 1;
/// ImGui needs a second frame until its panels have followed what happened, and a third until a form that has grown by
/// that is as large as it must be.
constexpr int kFramesAfterInput = 3;

std::string proposed_picture(const Source& source) {
    return source.followed().empty() ? "picture.png" : std::filesystem::path(source.path).stem().string() + ".png";
}

std::string proposed_export(const Source& source) {
    return source.followed().empty() ? "model.stl" : std::filesystem::path(source.path).stem().string() + ".stl";
}

std::string title_of(const Source& source) {
    return source.nothing() ? "csgscope" : Document(source).file_name() + " – csgscope";
}

/// Where one begins to look for files.
std::filesystem::path first_folder(const Source& source) {
    std::error_code error;
    const std::filesystem::path file = std::filesystem::absolute(source.followed(), error);
    const std::filesystem::path here = std::filesystem::current_path(error);
    return source.followed().empty() ? here : file.parent_path();
}

}  // namespace

WindowLoop::WindowLoop(const WindowOptions& options)
    : log_(options.frames_log),
      window_(title_of(options.source), kWindowSize),
      context_(gl::adopt_context(window_symbol, [this] { window_.make_current(); })),
      interface_(window_),
      picture_(*context_, options.engine, context_->software(), GlfwWindow::wake),
      session_(options, make_evaluate(), GlfwWindow::wake),
      inspection_(make_evaluate(), GlfwWindow::wake),
      open_form_(first_folder(options.source)),
      export_form_(proposed_export(options.source)),
      export_job_(GlfwWindow::wake),
      save_form_(proposed_picture(options.source), options.picture) {
    recent_.add(options.source.followed());
    console_height_ = 150 * window_.interface_scale();
    plan_.set_stoppable(picture_.threaded());
}

double WindowLoop::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - opened_).count();
}

WindowEnd WindowLoop::run() {
    while (!quit_) {
        if (window_.take_close_request()) {
            perform(Action::Quit);
            frames_to_draw_ = kFramesAfterInput;
            continue;
        }
        double rest = kPollSeconds;
        if (frames_to_draw_ > 0) {
            rest = advances_ ? kAdvanceSeconds : 0;
        } else if (!picture_.busy()) {
            rest = std::min(plan_.wait(seconds()).value_or(kPollSeconds), kPollSeconds);
        }
        if (session_.animation().plays()) {
            rest = std::min(rest, kAdvanceSeconds);
        }
        Input input = window_.wait(input_.empty() ? rest : 0);
        if (input.any && !only_hovers(input)) {
            input_.add(std::move(input));
        }
        const bool exported = receive_export(), received = receive() || exported;
        const bool updated = session_.update(seconds()), inspected = inspection_.update();
        // The status line counts the seconds of an evaluation, and says when it has ended without a result.
        std::optional<int> counted = session_.evaluating_for();
        if (!inspection_.task().empty()) {
            counted = counted.value_or(0) + inspection_.task_seconds();
        }
        if (const auto looking = session_.dynamics().looking_for()) {
            counted = counted.value_or(0) + *looking;
        }
        const bool counts = std::exchange(counted_, counted) != counted;
        if (updated || inspected || !input_.empty() || received || counts) {
            frames_to_draw_ = kFramesAfterInput;
        }
        if (frames_to_draw_ > 0 || (!picture_.busy() && plan_.next(seconds()))) {
            frame(input_.next());
        }
    }
    window_.hide();  // An evaluation may need a moment to stop.
    return finish();
}

/// A pointer that moves over the picture, with nothing held and nothing over it, changes nothing but what tools show.
bool WindowLoop::only_hovers(const Input& input) {
    const bool covered = session_.shown().covered() || ImGui::GetIO().WantCaptureMouse;
    const bool moves = !input.pointer.empty() && input.keys.empty() && !input.other &&
                       std::ranges::all_of(input.pointer, [&](const PointerEvent& event) {
                           return event.kind == PointerKind::Move && picture_place_.contains(event.position);
                       });
    // The first of them ends what was under the pointer before.
    if (!std::exchange(hovers_, moves) || !moves || covered || !input_.empty() || input_.any_held()) {
        return false;
    }
    bool changed = false;
    Commands none;
    use_tools([&](ToolContext& context) { changed = toolbox_.hover(context, input.pointer.back().position); }, none);
    return !changed && none.empty();
}

WindowEnd WindowLoop::finish() {
    while (saving_ > 0) {
        (void)window_.wait(kPollSeconds);
        (void)receive();
    }
    picture_.stop_drawing();
    for (const double end = seconds() + kLastPictureSeconds; picture_.busy();) {
        (void)window_.wait(0.02);
        if (seconds() > end) {
            return WindowEnd::StillDrawing;
        }
    }
    return WindowEnd::Done;
}

void WindowLoop::frame(const Input& input) {
    frames_to_draw_ = std::max(frames_to_draw_ - 1, 0);
    const glm::ivec2 pixels = window_.framebuffer_size(), size = window_.size();
    if (pixels.x < 1 || pixels.y < 1 || size.x < 1 || size.y < 1) {
        return;
    }
    Stopwatch watch;
    interface_.begin(input, input_, session_.settings());
    Commands commands;
    const Layout layout = draw_interface(commands);
    picture_place_ = layout.picture;
    navigate(input, commands);
    press_keys(input, commands);
    advance(commands);
    use_tools(
        [&](const ToolContext& context) {
            toolbox_.draw(context, {*ImGui::GetBackgroundDrawList(), interface_.fonts(), interface_.scale()});
        },
        commands);
    if (!input.dropped.empty()) {
        commands.emplace_back(OpenFile{input.dropped.front()});
    }
    for (const Command& command : commands) {
        perform(command);
        frames_to_draw_ = kFramesAfterInput;  // A form that opens is hidden in its first frame.
    }
    renew_title();
    const glm::ivec2 corner = pixel_corner(layout.picture), picture_size = pixel_size(layout.picture);
    plan_picture(picture_size);
    draw_picture();
    picture_.show(0, {corner.x, pixels.y - corner.y - picture_size.y}, picture_size,
                  session_.view().picture.scheme.background);
    interface_.end();
    window_.swap();
    log(watch.lap());
}

glm::ivec2 WindowLoop::pixel_corner(const Rectangle& place) const {
    return place.corner * glm::vec2(window_.framebuffer_size()) / glm::vec2(window_.size());
}

glm::ivec2 WindowLoop::pixel_size(const Rectangle& place) const {
    const glm::vec2 pixels_per_unit = glm::vec2(window_.framebuffer_size()) / glm::vec2(window_.size());
    return glm::max(glm::ivec2((place.corner + place.size) * pixels_per_unit) - pixel_corner(place), 1);
}

Layout WindowLoop::draw_interface(Commands& commands) {
    const float menu_height = draw_menu_bar(session_, info_, toolbox_.used(), commands);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const Fonts& fonts = interface_.fonts();
    const Layout layout =
        make_layout({size.x, size.y}, menu_height, interface_.scale(), session_.shown(), console_height_);
    draw_overlay(layout.picture, session_, info_, fonts, interface_.scale());
    draw_thickness_legend(layout.picture, session_, fonts, interface_.scale());
    const InspectionView inspected{session_, inspection_, fonts};
    if (session_.shown().inspection) {
        inspection_panel_.draw(layout.panel, inspected, commands);
    } else if (session_.shown().dynamics) {
        dynamics_panel_.draw(layout.panel, session_, fonts, commands);
    } else {
        draw_panel(layout.panel, session_, info_, fonts, commands);
    }
    draw_ghost(layout.picture, session_, interface_.scale());
    draw_inspected(layout.picture, inspected, interface_.scale());
    draw_animation(layout.animation, session_.animation(), commands);
    if (session_.shown().tree) {
        tree_panel_.draw(layout.left, session_, fonts, commands);
    } else if (session_.shown().text) {
        text_panel_.draw(layout.left, session_, fonts, commands);
    } else {
        customizer_panel_.draw(layout.left, session_.customizer(), fonts, commands);
    }
    draw_selection(layout.picture, session_, fonts, interface_.scale(), commands);
    draw_console(layout.console, session_, fonts, console_height_, commands);
    draw_status(layout.status, session_, info_, note_, commands);
    if (session_.shown().help) {
        draw_help(session_.settings(), fonts, commands);
    }
    if (session_.shown().open_form) {
        open_form_.draw(recent_.paths(), fonts, commands);
    } else if (session_.document().source().nothing()) {
        draw_start(layout.picture, recent_.paths(), fonts, commands);
    }
    if (session_.shown().settings_form) {
        settings_form_.draw(session_.settings(), fonts, commands);
    } else {
        settings_form_.stop_learning();
    }
    if (session_.shown().export_form) {
        export_form_.draw(commands);
    }
    draw_editing(layout.picture, session_, fonts, interface_.scale(), commands);
    if (session_.shown().palette) {
        palette_.draw(session_.settings().keys, commands);
    }
    if (session_.shown().save_form) {
        save_form_.draw(session_.view().request(pixel_size(layout.picture)), commands);
    }
    return layout;
}

void WindowLoop::open(const OpenFile& file) {
    if (!can_open(file.path)) {
        note_ = fmt::format("{} is no model", file.path.filename().string());
        return;
    }
    session_.perform(file);
    inspection_.clear();
    const Source& source = session_.document().source();
    save_form_.propose(proposed_picture(source));
    export_form_.propose(proposed_export(source));
    recent_.add(source.path);
    note_.clear();
}

void WindowLoop::export_model(const ExportModel& what) {
    const Source& source = session_.document().source();
    if (source.nothing()) {
        note_ = "There is nothing to export";
        return;
    }
    note_ = fmt::format("Exporting {}…", what.path.filename().string());
    export_job_.start(source, what.path);
}

void WindowLoop::export_frames() {
    const Source& source = session_.document().source();
    if (source.nothing()) {
        note_ = "There is nothing to export";
        return;
    }
    const PictureRequest picture = session_.view().request(pixel_size(picture_place_));
    const std::string camera = camera_option(picture.camera);
    std::vector<std::string> more{"--animate", std::to_string(session_.animation().steps()),
                                  "--style",   std::string(picture.style->name),
                                  "--size",    fmt::format("{}x{}", picture.size.x, picture.size.y),
                                  "--samples", std::to_string(picture.samples)};
    const std::size_t blank = camera.find(' '), next = camera.find(" --", blank);
    more.push_back("--camera=" + camera.substr(blank + 1, next - blank - 1));
    if (picture.camera.projection == base::Projection::Orthographic) {
        more.insert(more.end(), {"--projection", "o"});
    }
    const std::vector<std::string> glyphs = session_.dynamics().options();
    more.insert(more.end(), glyphs.begin(), glyphs.end());
    std::filesystem::path path = source.followed().empty() ? "frame.png" : source.path;
    path.replace_extension(".png");
    note_ = fmt::format("Exporting {} pictures…", session_.animation().steps());
    export_job_.start(source, path, more);
}

bool WindowLoop::receive_export() {
    const auto exported = export_job_.take();
    if (!exported) {
        return false;
    }
    const std::string name = exported->path.filename().string();
    note_ =
        exported->good ? fmt::format("Exported {}", exported->path.string()) : fmt::format("{} is not exported", name);
    if (!exported->text.empty()) {
        session_.tell(exported->good ? LineKind::Warning : LineKind::Error,
                      fmt::format("{}: {}", name, exported->text));
    }
    return true;
}

bool WindowLoop::asks_before(const Command& command) {
    const auto* action = std::get_if<Action>(&command);
    const bool leaves = std::holds_alternative<OpenFile>(command) || (action != nullptr && *action == Action::Quit);
    if (!leaves || !session_.editing().text().unsaved()) {
        return false;
    }
    leaving_ = command;
    session_.ask_before_leaving();
    return true;
}

void WindowLoop::leave(Leave::How how) {
    const std::optional<Command> waiting = std::exchange(leaving_, std::nullopt);
    session_.perform(Action::Close);
    if (how == Leave::How::Save) {
        session_.perform(Action::Save);
    } else if (how == Leave::How::Discard) {
        session_.discard_edits();
    }
    if (waiting && how != Leave::How::Stay && !session_.editing().text().unsaved()) {
        perform(*waiting);
    }
}

void WindowLoop::renew_title() {
    const std::string title =
        (session_.editing().text().unsaved() ? "● " : "") + title_of(session_.document().source());
    if (title != title_) {
        window_.set_title(title);
        title_ = title;
    }
}

void WindowLoop::perform(const Command& command) {
    const auto* action = std::get_if<Action>(&command);
    if (asks_before(command)) {
        return;
    }
    if (const auto* answer = std::get_if<Leave>(&command)) {
        leave(answer->how);
        return;
    }
    if (const auto* file = std::get_if<OpenFile>(&command)) {
        open(*file);
        return;
    }
    if (action != nullptr && perform_by_tools(*action)) {
        return;
    }
    if (action != nullptr && *action == Action::Close && !session_.shown().covered()) {
        inspection_.unmark();
    }
    const bool flies = std::holds_alternative<LookFrom>(command) || (action != nullptr && looks_from(*action));
    flight_.finish(session_.camera());
    const glm::dvec3 before = session_.camera().rotation;
    if (session_.perform(command)) {
        if (flies) {
            flight_.start(session_.camera(), before, seconds());
        }
    } else if (const auto* asked = std::get_if<InspectionCommand>(&command)) {
        inspect(*asked);
    } else if (const auto* selected = std::get_if<SelectAt>(&command)) {
        select(selected->at);
    } else if (const auto* exported = std::get_if<ExportModel>(&command)) {
        export_model(*exported);
    } else if (std::holds_alternative<ExportFrames>(command)) {
        export_frames();
    } else if (const auto* edit = std::get_if<EditText>(&command)) {
        note_ = open_editor(edit->path, edit->line, edit->column);
    } else if (const auto* write = std::get_if<WritePicture>(&command)) {
        save_picture(*write);
    } else if (action != nullptr) {
        quit_ = quit_ || *action == Action::Quit;
        copy(*action);
    }
}

void WindowLoop::inspect(const InspectionCommand& command) {
    const Document& document = session_.document();
    if (const auto* finding = std::get_if<ShowFinding>(&command)) {
        show(inspection_.finding(finding->index, document), true);
    } else if (const auto* thin = std::get_if<ShowThinPlace>(&command)) {
        show(inspection_.thin_place(thin->index, document), false);
    } else if (const auto* text = std::get_if<CopyText>(&command)) {
        window_.set_clipboard(text->text);
        note_ = "Copied";
    } else if (!document.source().nothing()) {
        (void)inspection_.perform(command, document, scad_view(session_.camera()));
    }
}

void WindowLoop::show(const InspectedPlace& place, bool turns) {
    base::Camera& camera = session_.camera();
    const glm::dvec3 before = camera.rotation,
                     middle = place.point + 0.5 * place.value * place.direction.value_or(glm::dvec3(0));
    if (const auto& model = session_.document().model(); turns && model) {
        const glm::dvec3 from = inspection_.sight(place, glm::normalize(camera.eye() - camera.target));
        const double diagonal = model->box.diagonal();
        const double height = std::clamp(12 * place.value, 0.2 * diagonal, diagonal);
        camera.rotation = base::camera_between(place.point + from, place.point).rotation;
        camera.distance = 0.5 * height / std::tan(glm::radians(0.5 * camera.fov));
        camera.target = middle;
    } else {
        session_.look_at(middle);
    }
    flight_.start(camera, before, seconds());
    session_.perform(SelectCall{place.occurrence, place.text, place.place});
    if (place.text.text) {
        session_.perform(ShowText{place.text});
    }
    inspection_.mark(place);
}

void WindowLoop::copy(Action action) {
    if (action == Action::CopyConsole) {
        window_.set_clipboard(session_.document().messages().text());
        note_ = "The console is copied";
    } else if (action == Action::CopyFound && !toolbox_.text().empty()) {
        window_.set_clipboard(toolbox_.text());
        note_ = "What is measured is copied";
    } else if (action == Action::CopyCamera) {
        const std::string option = camera_option(session_.view().picture.camera);
        window_.set_clipboard(option);
        note_ = "Copied: " + option;
    }
}

}  // namespace ui
