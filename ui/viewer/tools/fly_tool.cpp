#include "ui/viewer/tools/fly_tool.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/viewer/camera_control.h"
#include "ui/viewer/tool.h"

namespace ui {

namespace {

constexpr double kLookPerPixel = 0.3;    // Of what a drag turns otherwise: what is near runs by quicker.
constexpr double kModelPerSecond = 0.3;  // Of the model's diagonal.
constexpr double kQuicker = 4, kPerNotch = 1.25;

struct FlyKey {
    int keys[2];
    glm::dvec3 way;  ///< In eye coordinates.
};
constexpr std::array<FlyKey, 6> kKeys{{{{GLFW_KEY_W, GLFW_KEY_UP}, {0, 0, -1}},
                                       {{GLFW_KEY_S, GLFW_KEY_DOWN}, {0, 0, 1}},
                                       {{GLFW_KEY_A, GLFW_KEY_LEFT}, {-1, 0, 0}},
                                       {{GLFW_KEY_D, GLFW_KEY_RIGHT}, {1, 0, 0}},
                                       {{GLFW_KEY_E, GLFW_KEY_PAGE_UP}, {0, 1, 0}},
                                       {{GLFW_KEY_Q, GLFW_KEY_PAGE_DOWN}, {0, -1, 0}}}};

class FlyTool : public Tool {
  public:
    void begin(ToolContext& context) override {
        if (context.camera.projection == base::Projection::Orthographic) {
            toggle_projection(context.camera);  // Parallel rays have no eye.
        }
    }

    bool press(ToolContext& /*context*/, const PointerEvent& event) override {
        last_ = event.position;
        return event.button == Button::Left;
    }

    void drag(ToolContext& context, const glm::dvec2& at) override {
        const glm::dvec3 eye = context.camera.eye();
        orbit(context.camera, -kLookPerPixel * (at - std::exchange(last_, at)));
        context.camera.target += eye - context.camera.eye();
    }

    bool scroll(ToolContext& /*context*/, const PointerEvent& event) override {
        speed_ = std::clamp(speed_ * std::pow(kPerNotch, event.amount), 0.01, 100.0);
        return true;
    }

    bool key(ToolContext& /*context*/, const KeyEvent& event) override {
        return (event.chord.modifiers & ~GLFW_MOD_SHIFT) == 0 &&
               std::any_of(kKeys.begin(), kKeys.end(),
                           [&](const FlyKey& each) { return event.key == each.keys[0] || event.key == each.keys[1]; });
    }

    bool advance(ToolContext& context, double seconds) override {
        glm::dvec3 way(0);
        for (const FlyKey& each : kKeys) {
            way += context.held(each.keys[0]) || context.held(each.keys[1]) ? each.way : glm::dvec3(0);
        }
        const auto& model = context.session.document().model();
        if (way == glm::dvec3(0) || context.held(GLFW_KEY_LEFT_CONTROL) || !model || model->empty()) {
            return false;
        }
        const bool quick = context.held(GLFW_KEY_LEFT_SHIFT) || context.held(GLFW_KEY_RIGHT_SHIFT);
        const double length =
            kModelPerSecond * speed_ * (quick ? kQuicker : 1) * glm::length(model->box.size()) * seconds;
        const glm::dmat3 world_from_eye = glm::transpose(glm::dmat3(context.camera.eye_from_world()));
        context.camera.target += world_from_eye * glm::normalize(way) * length;
        return true;
    }

  private:
    glm::dvec2 last_{0};
    double speed_ = 1;  ///< Of the usual one.
};

}  // namespace

std::unique_ptr<Tool> make_fly_tool() {
    return std::make_unique<FlyTool>();
}

}  // namespace ui
