#include "ui/viewer/mouse_preset.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace ui {

namespace {

constexpr int kShift = GLFW_MOD_SHIFT, kCtrl = GLFW_MOD_CONTROL;

constexpr std::array kOwn{
    MouseBinding{Button::Left, 0, DragMotion::Turn},       MouseBinding{Button::Left, kShift, DragMotion::Shift},
    MouseBinding{Button::Right, 0, DragMotion::Shift},     MouseBinding{Button::Middle, 0, DragMotion::Shift},
    MouseBinding{Button::Right, kShift, DragMotion::Zoom}, MouseBinding{Button::Middle, kShift, DragMotion::Zoom}};
constexpr std::array kOpenScad{
    MouseBinding{Button::Left, 0, DragMotion::Turn},       MouseBinding{Button::Left, kShift, DragMotion::Turn},
    MouseBinding{Button::Right, 0, DragMotion::Shift},     MouseBinding{Button::Middle, 0, DragMotion::Shift},
    MouseBinding{Button::Right, kShift, DragMotion::Zoom}, MouseBinding{Button::Middle, kShift, DragMotion::Zoom}};
constexpr std::array kBlender{MouseBinding{Button::Middle, 0, DragMotion::Turn},
                              MouseBinding{Button::Middle, kShift, DragMotion::Shift},
                              MouseBinding{Button::Middle, kCtrl, DragMotion::Zoom}};
constexpr std::array kFusion{MouseBinding{Button::Middle, 0, DragMotion::Shift},
                             MouseBinding{Button::Middle, kShift, DragMotion::Turn}};
constexpr std::array kFreeCad{MouseBinding{Button::Middle, 0, DragMotion::Shift},
                              MouseBinding{Button::Right, kCtrl, DragMotion::Shift},
                              MouseBinding{Button::Left, 0, DragMotion::Turn, Button::Middle},
                              MouseBinding{Button::Right, 0, DragMotion::Turn, Button::Middle},
                              MouseBinding{Button::Right, kShift, DragMotion::Turn},
                              MouseBinding{Button::Right, kShift | kCtrl, DragMotion::Zoom}};

constexpr std::array kPresets{
    MousePreset{"csgscope", kOwn, "left turns, right or middle or Shift + left shifts, Shift + right zooms"},
    MousePreset{"OpenSCAD", kOpenScad, "left turns, right or middle shifts, Shift + right or middle zooms"},
    MousePreset{"Blender", kBlender, "middle turns, Shift + middle shifts, Ctrl + middle zooms"},
    MousePreset{"Fusion", kFusion, "middle shifts, Shift + middle turns"},
    MousePreset{"FreeCAD", kFreeCad,
                "middle shifts, middle and then left or right turns, Shift + right turns, Ctrl + right shifts"}};

}  // namespace

std::span<const MousePreset> mouse_presets() {
    return kPresets;
}

std::size_t mouse_preset(std::string_view name) {
    const auto* const found =
        std::find_if(kPresets.begin(), kPresets.end(), [&](const MousePreset& each) { return each.name == name; });
    return found == kPresets.end() ? 0 : static_cast<std::size_t>(std::distance(kPresets.begin(), found));
}

DragMotion motion_of(const MousePreset& preset, Button button, int modifiers, Button held) {
    for (const MouseBinding& each : preset.bindings) {
        if (each.button == button && each.modifiers == modifiers && each.held == held) {
            return each.motion;
        }
    }
    return DragMotion::None;
}

}  // namespace ui
