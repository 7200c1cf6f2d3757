#include "ui/viewer/navigator.h"

#include <cmath>
#include <utility>

#include "ui/viewer/camera_control.h"

namespace ui {

namespace {

constexpr double kZoomPerNotch = 1.15, kZoomPerUnit = 1.01;
constexpr double kClickDistance = 3;  // Units that the pointer may move meanwhile.
constexpr double kDoubleClickSeconds = 0.4, kDoubleClickDistance = 5;

}  // namespace

void Navigator::ask(const PointerEvent& event, const Rectangle& picture) {
    question_ = asked_ = event.position - glm::dvec2(picture.corner);
    pivot_.reset();
}

void Navigator::press(const PointerEvent& event, const Rectangle& picture) {
    if (event.button == Button::Left) {
        const bool second = event.time - clicked_at_ < kDoubleClickSeconds &&
                            glm::distance(event.position, clicked_) < kDoubleClickDistance;
        if (second) {
            double_click_ = event.position - glm::dvec2(picture.corner);
        }
        clicked_at_ = second ? -1 : event.time;
        clicked_ = event.position;
    }
    ask(event, picture);
    dragged_ = false;
    before_ = std::exchange(button_, event.button);
    modifiers_ = event.modifiers;
    const MousePreset& preset = mouse_presets()[preset_];
    motion_ = motion_of(preset, event.button, event.modifiers, before_);
    if (motion_ == DragMotion::None && before_ != Button::None) {
        motion_ = motion_of(preset, event.button, event.modifiers, Button::None);
    }
    last_ = event.position;
}

void Navigator::release(const PointerEvent& event, const Rectangle& picture) {
    if (event.button == before_) {
        before_ = Button::None;  // The later one goes on alone.
    }
    if (event.button != button_) {
        return;
    }
    if (button_ == Button::Left && !dragged_ && modifiers_ == 0 && before_ == Button::None && clicked_at_ >= 0) {
        click_ = event.position - glm::dvec2(picture.corner);
    }
    button_ = std::exchange(before_, Button::None);
    motion_ = motion_of(mouse_presets()[preset_], button_, 0, Button::None);
}

void Navigator::drag(const glm::dvec2& way, int height, base::Camera& camera) const {
    switch (motion_) {
        case DragMotion::None:
            break;
        case DragMotion::Shift:
            pan(camera, way, height);
            break;
        case DragMotion::Zoom:
            zoom(camera, std::pow(kZoomPerUnit, way.y), pivot_.value_or(camera.target));
            break;
        case DragMotion::Turn:
            if (pivot_) {
                orbit_about(camera, way, *pivot_);
            } else {
                orbit(camera, way);
            }
            break;
    }
}

void Navigator::handle(const PointerEvent& event, const Rectangle& picture, bool free, base::Camera& camera) {
    const int height = static_cast<int>(picture.size.y);
    switch (event.kind) {
        case PointerKind::Press:
            if (button_ != Button::None || (free && picture.contains(event.position))) {
                press(event, picture);
            }
            break;
        case PointerKind::Release:
            release(event, picture);
            break;
        case PointerKind::Move: {
            const glm::dvec2 drag = event.position - std::exchange(last_, event.position);
            if (button_ != Button::None && drag != glm::dvec2(0)) {
                asked_.reset();  // What lies there is another now.
            }
            dragged_ = dragged_ || glm::distance(event.position, clicked_) > kClickDistance;
            if (button_ != Button::None && drag != glm::dvec2(0)) {
                this->drag(drag, height, camera);
            }
            break;
        }
        case PointerKind::Scroll:
            if (free && picture.contains(event.position)) {
                const glm::dvec2 cursor = event.position - glm::dvec2(picture.corner);
                if (!asked_ || glm::distance(*asked_, cursor) > kClickDistance) {
                    ask(event, picture);
                }
                // About a surface, so that nothing is flown through, however far one goes.
                zoom(camera, std::pow(kZoomPerNotch, -event.amount),
                     pivot_ ? *pivot_ : point_on_target_plane(camera, glm::ivec2(picture.size), cursor));
            }
            break;
    }
}

std::optional<glm::dvec2> Navigator::take_question() {
    return std::exchange(question_, std::nullopt);
}

std::optional<glm::dvec2> Navigator::take_click() {
    return std::exchange(click_, std::nullopt);
}

std::optional<glm::dvec2> Navigator::take_double_click() {
    return std::exchange(double_click_, std::nullopt);
}

}  // namespace ui
