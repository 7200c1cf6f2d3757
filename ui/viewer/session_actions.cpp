// What commands do to document and view.
#include <algorithm>
#include <utility>

#include "ui/pipeline/sections.h"
#include "ui/viewer/session.h"

namespace ui {

namespace {

constexpr double kTurn = 15;  // Degrees per key press.
constexpr double kZoom = 1.25;

/// Turns by whole key presses, with orbit()'s rules.
void turn(base::Camera& camera, double about_x, double about_z) {
    constexpr double kPixelsPerDegree = 1 / 0.7;
    orbit(camera, {-about_z * kPixelsPerDegree, -about_x * kPixelsPerDegree});
}

}  // namespace

bool Session::perform(const Command& command) {
    if (const auto* action = std::get_if<Action>(&command)) {
        return act(*action);
    }
    if (change_settings(command) || animate(command) || look_at_tree(command) || edit_by_hand(command)) {
        return true;
    }
    if (const auto* asked = std::get_if<InspectionCommand>(&command)) {
        return inspect(*asked);
    }
    if (const auto* glyphs = std::get_if<DynamicsCommand>(&command)) {
        return act_on_dynamics(*glyphs);
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
    } else if (const auto* media = std::get_if<SetMedia>(&command)) {
        view_.picture.media = media->media;
        view_.picture.medium_light = media->light;
    } else if (const auto* layers = std::get_if<SetLayers>(&command)) {
        view_.picture.layers = std::max(layers->layers, npr::kLayersOfStyle);
    } else if (const auto* samples = std::get_if<SetSamples>(&command)) {
        view_.picture.samples = static_cast<int>(npr::sample_offsets(samples->samples).size());
    } else if (const auto* sections = std::get_if<SetSections>(&command)) {
        cut(sections->sections);
    } else if (const auto* look = std::get_if<LookFrom>(&command)) {
        view_.picture.camera.rotation = rotation_from(look->side, view_.picture.camera.rotation);
    } else if (const auto* explain = std::get_if<Explain>(&command)) {
        document_.explain(explain->call);
        document_.compare(std::nullopt);
        clear_selection();
        evaluate();
    } else if (const auto* text = std::get_if<ShowText>(&command)) {
        show_text(text->place);
    } else if (const auto* step = std::get_if<StepSelection>(&command)) {
        selection_.step(step->by);
        mark_selected();
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

bool Session::animate(const Command& command) {
    if (const auto* step = std::get_if<SetStep>(&command)) {
        animation_.go_to(step->step);
        run_animation();
    } else if (const auto* steps = std::get_if<SetSteps>(&command)) {
        animation_.set_steps(steps->steps);
    } else if (const auto* rate = std::get_if<SetRate>(&command)) {
        animation_.set_rate(rate->steps_per_second);
        animation_.play(animation_.plays(), now_);
    } else {
        return false;
    }
    return true;
}

bool Session::look_at_tree(const Command& command) {
    if (const auto* selected = std::get_if<SelectCall>(&command)) {
        clear_selection();
        mark(selected->occurrence, selected->place);
        if (selected->text.text) {
            text_ = selected->text;
        }
    } else if (const auto* hidden = std::get_if<HideCall>(&command)) {
        document_.hide(hidden->call, hidden->hidden);
        evaluate();
    } else if (const auto* alone = std::get_if<ShowAlone>(&command)) {
        document_.show_alone(alone->call);
        evaluate();
    } else {
        return false;
    }
    return true;
}

bool Session::inspect(const InspectionCommand& command) {
    if (const auto* thickness = std::get_if<SetThickness>(&command)) {
        view_.thickness = thickness->thickness;
    } else if (const auto* compared = std::get_if<CompareWith>(&command)) {
        document_.explain(std::nullopt);
        document_.compare(compared->before);
        evaluate();
    } else {
        return false;
    }
    return true;
}

bool Session::change_settings(const Command& command) {
    const Settings before = settings_;
    if (const auto* mouse = std::get_if<SetMouse>(&command)) {
        settings_.mouse = mouse->preset;
    } else if (const auto* theme = std::get_if<SetLightTheme>(&command)) {
        settings_.light = theme->light;
    } else if (const auto* text = std::get_if<SetTextSize>(&command)) {
        settings_.text_size = text->size;
    } else if (const auto* key = std::get_if<SetKey>(&command)) {
        settings_.keys.set(key->action, {key->chord});
    } else if (std::holds_alternative<ResetKeys>(command)) {
        settings_.keys.reset();
    } else {
        return false;
    }
    if (settings_ != before) {
        write_settings(settings_file_, settings_);
    }
    return true;
}

bool Session::act(Action action) {
    if (edit_text(action)) {
        return true;
    }
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
        case Action::ToggleScales:
            shown_.scales = !shown_.scales;
            break;
        case Action::ToggleGrid:
            shown_.grid = !shown_.grid;
            break;
        case Action::ToggleCube:
            shown_.cube = !shown_.cube;
            break;
        case Action::TogglePanel:
            shown_.panel = !shown_.panel || shown_.inspection || shown_.dynamics;
            shown_.inspection = shown_.dynamics = false;
            break;
        case Action::ToggleText:
            shown_.text = !shown_.text;
            shown_.customizer = shown_.tree = false;
            break;
        case Action::ToggleCustomizer:
            shown_.customizer = !shown_.customizer;
            shown_.text = shown_.tree = false;
            break;
        case Action::ToggleTree:
            shown_.tree = !shown_.tree;
            shown_.text = shown_.customizer = false;
            break;
        case Action::ToggleAnimation:
            shown_.animation = !shown_.animation;
            animation_.play(false, now_);
            break;
        case Action::PlayPause:
            shown_.animation = true;
            animation_.play(!animation_.plays(), now_);
            break;
        case Action::StepBack:
        case Action::StepOn:
            shown_.animation = true;
            animation_.go_to(animation_.step() + (action == Action::StepOn ? 1 : -1));
            run_animation();
            break;
        case Action::ToggleInspection:
            shown_.inspection = !shown_.inspection;
            shown_.dynamics = false;
            break;
        case Action::ToggleDynamics:
            shown_.dynamics = !shown_.dynamics;
            shown_.inspection = false;
            follow_motion();
            break;
        case Action::Settings:
            shown_.settings_form = true;
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
        case Action::SelectTool:
        case Action::MoveTool:
        case Action::TurnTool:
        case Action::SizeTool:
        case Action::ScaleTool:
        case Action::FlyTool:
        case Action::MeasureTool:
        case Action::CopyFound:
        case Action::Quit:
        case Action::CopyConsole:
        case Action::CopyCamera:
            return false;
        default:  // Of editing.
            return false;
    }
    return true;
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
