#include "ui/viewer/navigator.h"

#include <cmath>
#include <utility>

#include "ui/viewer/camera_control.h"

namespace ui {

namespace {

constexpr double kZoomPerNotch = 1.15;
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
    button_ = event.button;
    pans_ = event.button != Button::Left || event.shift;
    last_ = event.position;
}

void Navigator::handle(const PointerEvent& event, const Rectangle& picture, bool free, base::Camera& camera) {
    const int height = static_cast<int>(picture.size.y);
    switch (event.kind) {
        case PointerKind::Press:
            if (button_ == Button::None && free && picture.contains(event.position)) {
                press(event, picture);
            }
            break;
        case PointerKind::Release:
            if (event.button == button_) {
                if (button_ == Button::Left && !dragged_ && !pans_ && clicked_at_ >= 0) {
                    click_ = event.position - glm::dvec2(picture.corner);
                }
                button_ = Button::None;
            }
            break;
        case PointerKind::Move: {
            const glm::dvec2 drag = event.position - std::exchange(last_, event.position);
            if (button_ != Button::None && drag != glm::dvec2(0)) {
                asked_.reset();  // What lies there is another now.
            }
            dragged_ = dragged_ || glm::distance(event.position, clicked_) > kClickDistance;
            if (button_ != Button::None && drag != glm::dvec2(0)) {
                if (pans_) {
                    pan(camera, drag, height);
                } else if (pivot_) {
                    orbit_about(camera, drag, *pivot_);
                } else {
                    orbit(camera, drag);
                }
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
