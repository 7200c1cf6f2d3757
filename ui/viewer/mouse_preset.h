// What the mouse's buttons do to the camera: as in this program, or as in others that hands are used to.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "ui/viewer/input.h"

namespace ui {

enum class DragMotion { None, Turn, Shift, Zoom };

struct MouseBinding {
    Button button;
    int modifiers;  ///< GLFW's; exactly these are held.
    DragMotion motion;
    Button held = Button::None;  ///< The button that was pressed before, if one must be.
};

struct MousePreset {
    const char* name;  ///< "Blender"
    std::span<const MouseBinding> bindings;
    const char* text;  ///< What it does, for people.
};

/// The first is this program's own.
[[nodiscard]] std::span<const MousePreset> mouse_presets();

/// The index of the preset; 0 where there is none of that name.
[[nodiscard]] std::size_t mouse_preset(std::string_view name);

/// What a drag with the button does. `held`: another that was pressed before and is held still.
[[nodiscard]] DragMotion motion_of(const MousePreset& preset, Button button, int modifiers, Button held);

}  // namespace ui
