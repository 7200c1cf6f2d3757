// Where input goes: to the tools, then to the camera and to the shortcuts.
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "ui/viewer/camera_control.h"
#include "ui/viewer/window_loop.h"

namespace ui {

namespace {

/// A frame that took longer moves nothing farther: what was to be seen meanwhile was not.
constexpr double kLongestStep = 0.1;

bool is_modifier(int key) {
    return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}

}  // namespace

void WindowLoop::use_tools(const std::function<void(ToolContext&)>& use, Commands& commands) {
    ToolContext context{
        session_,           picture_place_,
        interface_.scale(), session_.camera(),
        commands,           [](int key) { return !ImGui::GetIO().WantTextInput && ImGui::IsKeyDown(key); }};
    use(context);
    question_ = context.question ? context.question : question_;
}

base::Camera WindowLoop::narrowed(const glm::dvec2& at) {
    return pixel_camera(session_.camera(), glm::ivec2(picture_place_.size), at);
}

void WindowLoop::navigate(const Input& input, Commands& commands) {
    const bool free = !ImGui::GetIO().WantCaptureMouse;
    navigator_.set_preset(session_.settings().mouse);
    for (const PointerEvent& event : input.pointer) {
        use_tools(
            [&](ToolContext& context) {
                const bool held = toolbox_.dragging() || navigator_.dragging();
                if (event.kind == PointerKind::Move && !held) {
                    const bool over = free && picture_place_.contains(event.position);
                    (void)toolbox_.hover(context, over ? std::optional(event.position) : std::nullopt);
                }
                if (navigator_.dragging() || !toolbox_.handle(context, event, free)) {
                    navigator_.handle(event, picture_place_, free, session_.camera());
                }
                if (const auto clicked = navigator_.take_click()) {
                    toolbox_.click(context, *clicked + glm::dvec2(picture_place_.corner));
                }
            },
            commands);
    }
    if (navigator_.dragging() || toolbox_.dragging()) {
        flight_.stop();
    }
    const auto centered = navigator_.take_double_click(), question = navigator_.take_question();
    const auto& model = session_.document().model();
    if (!model || model->empty()) {
        return;
    }
    const npr::Sections& sections = session_.view().picture.sections;
    if (question) {
        picture_.pick(model, sections, narrowed(*question), PickFor::Navigation);
    }
    if (centered) {
        picture_.pick(model, sections, narrowed(*centered));
    }
    if (!asked_ && question_) {
        const glm::dvec2 at = *std::exchange(question_, std::nullopt);
        asked_ = true;
        picture_.probe(model, sections, narrowed(at - glm::dvec2(picture_place_.corner)), at);
    }
}

void WindowLoop::select(const glm::dvec2& at) {
    const auto& model = session_.document().model();
    const auto& sources = session_.document().model_sources();
    if (model && !model->empty() && sources) {
        picture_.select(model, sources, session_.view().picture.sections, narrowed(at), at);
    }
}

void WindowLoop::press_keys(const Input& input, Commands& commands) {
    const bool typing = ImGui::GetIO().WantTextInput;
    const Keys& keys = session_.settings().keys;
    for (const KeyEvent& event : input.keys) {
        if (const auto learns = settings_form_.learns(); learns && !is_modifier(event.key)) {
            if (keys.action_of(event.chord) != Action::Close) {
                commands.emplace_back(SetKey{*learns, event.chord});
            }
            settings_form_.stop_learning();
            continue;
        }
        bool used = text_panel_.focused() && (text_panel_.uses(event.chord) || event.chord.key == GLFW_KEY_ESCAPE);
        if (used && event.chord.key == GLFW_KEY_ESCAPE) {
            text_panel_.leave();
        }
        if (!typing && !session_.shown().covered()) {
            use_tools([&](ToolContext& context) { used = toolbox_.key(context, event); }, commands);
        }
        const auto action = used ? std::nullopt : keys.action_of(event.chord);
        if (action && (!typing || text_panel_.focused() || *action == Action::Close)) {
            commands.emplace_back(*action);
        }
    }
}

void WindowLoop::advance(Commands& commands) {
    const double now = seconds(), passed = std::min(now - std::exchange(advanced_, now), kLongestStep);
    flight_.advance(session_.camera(), now);
    advances_ = flight_.under_way();
    if (!ImGui::GetIO().WantTextInput) {
        use_tools([&](ToolContext& context) { advances_ |= toolbox_.advance(context, passed); }, commands);
    }
    if (advances_) {
        frames_to_draw_ = std::max(frames_to_draw_, 1);
    }
}

bool WindowLoop::perform_by_tools(Action action) {
    bool done = false;
    Commands commands;
    use_tools(
        [&](ToolContext& context) {
            if (action == Action::Close) {
                done = !session_.shown().covered() && toolbox_.cancel(context);
            } else {
                done = toolbox_.use(context, action);
            }
        },
        commands);
    if (done) {
        note_ = toolbox_.info().hint;
    }
    for (const Command& command : commands) {
        perform(command);
    }
    return done;
}

}  // namespace ui
