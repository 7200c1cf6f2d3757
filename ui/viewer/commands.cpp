#include "ui/viewer/commands.h"

#include <fmt/format.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>

namespace ui {

namespace {

constexpr int kCtrl = GLFW_MOD_CONTROL, kShift = GLFW_MOD_SHIFT;

// The digits with Ctrl and Ctrl+Shift+V are OpenSCAD's.
constexpr std::array kActions{
    ActionInfo{Action::Open, "File", "Open…", {{GLFW_KEY_O, kCtrl}}},
    ActionInfo{Action::Reload, "File", "Reload", {{GLFW_KEY_F5}, {GLFW_KEY_F4}, {GLFW_KEY_R, kCtrl}}},
    ActionInfo{Action::Cancel, "File", "Cancel the evaluation", {{GLFW_KEY_PERIOD, kCtrl}}},
    ActionInfo{Action::Save, "File", "Save", {{GLFW_KEY_S, kCtrl}}},
    ActionInfo{Action::SavePicture, "File", "Save picture…", {{GLFW_KEY_S, kCtrl | kShift}}},
    ActionInfo{Action::Export, "File", "Export…", {{GLFW_KEY_E, kCtrl}}},
    ActionInfo{Action::Quit, "File", "Quit", {{GLFW_KEY_Q, kCtrl}, {GLFW_KEY_W, kCtrl}}},

    ActionInfo{Action::Undo, "Edit", "Undo", {{GLFW_KEY_Z, kCtrl}}},
    ActionInfo{Action::Redo, "Edit", "Redo", {{GLFW_KEY_Z, kCtrl | kShift}, {GLFW_KEY_Y, kCtrl}}},
    ActionInfo{Action::Duplicate, "Edit", "Duplicate", {{GLFW_KEY_D, kCtrl}}},
    ActionInfo{Action::DeleteSelected, "Edit", "Delete", {{GLFW_KEY_DELETE}}},
    ActionInfo{Action::Palette, "Edit", "All actions…", {{GLFW_KEY_F3}, {GLFW_KEY_P, kCtrl}}},

    ActionInfo{Action::AddCube, "Add", "Cube", {}},
    ActionInfo{Action::AddSphere, "Add", "Sphere", {}},
    ActionInfo{Action::AddCylinder, "Add", "Cylinder", {}},
    ActionInfo{Action::AddCone, "Add", "Cone", {}},
    ActionInfo{Action::AddText, "Add", "Raised text", {}},
    ActionInfo{Action::AddExtrusion, "Add", "Extruded polygon", {}},
    ActionInfo{Action::ToggleHole, "Add", "As a hole", {{GLFW_KEY_H, kCtrl}}},

    ActionInfo{Action::MirrorX, "Arrange", "Mirror along x", {}},
    ActionInfo{Action::MirrorY, "Arrange", "Mirror along y", {}},
    ActionInfo{Action::MirrorZ, "Arrange", "Mirror along z", {}},
    ActionInfo{Action::RowX, "Arrange", "Row along x", {}},
    ActionInfo{Action::RowY, "Arrange", "Row along y", {}},
    ActionInfo{Action::RowZ, "Arrange", "Row along z", {}},
    ActionInfo{Action::CircleZ, "Arrange", "Circle about z", {}},
    ActionInfo{Action::Group, "Arrange", "Group", {{GLFW_KEY_G, kCtrl}}},
    ActionInfo{Action::Ungroup, "Arrange", "Ungroup", {{GLFW_KEY_G, kCtrl | kShift}}},
    ActionInfo{Action::MakeUnion, "Arrange", "Make it a union", {}},
    ActionInfo{Action::MakeDifference, "Arrange", "Make it a difference", {}},
    ActionInfo{Action::MakeIntersection, "Arrange", "Make it an intersection", {}},
    ActionInfo{Action::MakeHull, "Arrange", "Make it a hull", {}},
    ActionInfo{Action::MakeMinkowski, "Arrange", "Make it a Minkowski sum", {}},
    ActionInfo{Action::MarkHighlight, "Arrange", "Highlight (#)", {}},
    ActionInfo{Action::MarkBackground, "Arrange", "Background (%)", {}},
    ActionInfo{Action::MarkOnly, "Arrange", "Only this (!)", {}},
    ActionInfo{Action::MarkDisabled, "Arrange", "Disable (*)", {}},

    ActionInfo{Action::ViewAll, "View", "View all", {{GLFW_KEY_V}, {GLFW_KEY_HOME}, {GLFW_KEY_V, kCtrl | kShift}}},
    ActionInfo{Action::ResetView, "View", "Reset view", {{GLFW_KEY_HOME, kShift}}},
    ActionInfo{Action::LookAtOrigin, "View", "Center on the origin", {{GLFW_KEY_0, kCtrl | kShift}}},
    ActionInfo{Action::Top, "View", "Top", {{GLFW_KEY_4, kCtrl}, {GLFW_KEY_4}}, glm::dvec3(0, 0, 0)},
    ActionInfo{Action::Bottom, "View", "Bottom", {{GLFW_KEY_5, kCtrl}, {GLFW_KEY_5}}, glm::dvec3(180, 0, 0)},
    ActionInfo{Action::Left, "View", "Left", {{GLFW_KEY_6, kCtrl}, {GLFW_KEY_6}}, glm::dvec3(90, 0, 270)},
    ActionInfo{Action::Right, "View", "Right", {{GLFW_KEY_7, kCtrl}, {GLFW_KEY_7}}, glm::dvec3(90, 0, 90)},
    ActionInfo{Action::Front, "View", "Front", {{GLFW_KEY_8, kCtrl}, {GLFW_KEY_8}}, glm::dvec3(90, 0, 0)},
    ActionInfo{Action::Back, "View", "Back", {{GLFW_KEY_9, kCtrl}, {GLFW_KEY_9}}, glm::dvec3(90, 0, 180)},
    ActionInfo{Action::Diagonal, "View", "Diagonal", {{GLFW_KEY_0, kCtrl}, {GLFW_KEY_0}}, glm::dvec3(55, 0, 25)},
    ActionInfo{Action::ToggleProjection, "View", "Perspective or orthographic", {{GLFW_KEY_P}, {GLFW_KEY_O}}},

    ActionInfo{Action::ZoomIn, "Camera", "Zoom in", {{GLFW_KEY_EQUAL}, {GLFW_KEY_KP_ADD}, {GLFW_KEY_EQUAL, kShift}}},
    ActionInfo{Action::ZoomOut, "Camera", "Zoom out", {{GLFW_KEY_MINUS}, {GLFW_KEY_KP_SUBTRACT}}},
    ActionInfo{Action::TurnLeft, "Camera", "Turn left", {{GLFW_KEY_LEFT}}},
    ActionInfo{Action::TurnRight, "Camera", "Turn right", {{GLFW_KEY_RIGHT}}},
    ActionInfo{Action::TurnUp, "Camera", "Turn up", {{GLFW_KEY_UP}}},
    ActionInfo{Action::TurnDown, "Camera", "Turn down", {{GLFW_KEY_DOWN}}},
    ActionInfo{Action::CopyFound, "Camera", "Copy what is measured", {{GLFW_KEY_C, kCtrl}}},
    ActionInfo{Action::CopyCamera, "Camera", "Copy as --camera", {}},

    ActionInfo{Action::NextStyle, "Style", "Next style", {{GLFW_KEY_S}}},
    ActionInfo{Action::PreviousStyle, "Style", "Previous style", {{GLFW_KEY_S, kShift}}},
    ActionInfo{Action::MoreLayers, "Style", "One layer more", {{GLFW_KEY_L}}},
    ActionInfo{Action::FewerLayers, "Style", "One layer less", {{GLFW_KEY_L, kShift}}},
    ActionInfo{Action::PlayPause, "Style", "Play or pause $t", {{GLFW_KEY_SPACE, kCtrl}}},
    ActionInfo{Action::StepBack, "Style", "A step of $t back", {{GLFW_KEY_COMMA}}},
    ActionInfo{Action::StepOn, "Style", "A step of $t on", {{GLFW_KEY_PERIOD}}},

    ActionInfo{Action::SelectTool, "Tool", "Select", {{GLFW_KEY_SPACE}}},
    ActionInfo{Action::MoveTool, "Tool", "Move", {{GLFW_KEY_W}}},
    ActionInfo{Action::TurnTool, "Tool", "Turn", {{GLFW_KEY_R}}},
    ActionInfo{Action::SizeTool, "Tool", "Size", {{GLFW_KEY_E}}},
    ActionInfo{Action::ScaleTool, "Tool", "Scale", {{GLFW_KEY_K}}},
    ActionInfo{Action::MeasureTool, "Tool", "Measure", {{GLFW_KEY_M}}},
    ActionInfo{Action::FlyTool, "Tool", "Fly", {{GLFW_KEY_F}}},

    ActionInfo{Action::ToggleAxes, "Window", "Axes", {{GLFW_KEY_A}, {GLFW_KEY_2, kCtrl}}},
    ActionInfo{Action::ToggleScales, "Window", "Axes and scales in the scene", {{GLFW_KEY_X}}},
    ActionInfo{Action::ToggleGrid, "Window", "Grid", {{GLFW_KEY_G}}},
    ActionInfo{Action::ToggleCube, "Window", "View cube", {{GLFW_KEY_B}}},
    ActionInfo{Action::TogglePanel, "Window", "Drawing panel", {{GLFW_KEY_F8}}},
    ActionInfo{Action::ToggleText, "Window", "Text", {{GLFW_KEY_F6}, {GLFW_KEY_T}}},
    ActionInfo{Action::ToggleCustomizer, "Window", "Customizer", {{GLFW_KEY_F7}}},
    ActionInfo{Action::ToggleTree, "Window", "Tree", {{GLFW_KEY_F10}}},
    ActionInfo{Action::ToggleAnimation, "Window", "Animation", {{GLFW_KEY_F11}}},
    ActionInfo{Action::ToggleInspection, "Window", "Inspection", {{GLFW_KEY_I}}},
    ActionInfo{Action::ToggleDynamics, "Window", "Motion and labels", {{GLFW_KEY_D}}},
    ActionInfo{Action::ToggleConsole, "Window", "Console", {{GLFW_KEY_F9}, {GLFW_KEY_C}}},
    ActionInfo{Action::Settings, "Window", "Settings…", {{GLFW_KEY_COMMA, kCtrl}}},
    ActionInfo{Action::ClearConsole, "Window", "Clear console", {}},
    ActionInfo{Action::CopyConsole, "Window", "Copy console", {{GLFW_KEY_C, kCtrl | kShift}}},

    ActionInfo{Action::Help, "Help", "Keys and mouse", {{GLFW_KEY_F1}, {GLFW_KEY_H}}},
    ActionInfo{Action::Close, "Help", "Close what lies over the picture", {{GLFW_KEY_ESCAPE}}},
};

std::string key_name(int key) {
    switch (key) {
        case GLFW_KEY_SPACE:
            return "Space";
        case GLFW_KEY_HOME:
            return "Home";
        case GLFW_KEY_LEFT:
            return "Left";
        case GLFW_KEY_RIGHT:
            return "Right";
        case GLFW_KEY_UP:
            return "Up";
        case GLFW_KEY_DOWN:
            return "Down";
        case GLFW_KEY_ESCAPE:
            return "Esc";
        case GLFW_KEY_ENTER:
            return "Enter";
        case GLFW_KEY_TAB:
            return "Tab";
        case GLFW_KEY_BACKSPACE:
            return "Backspace";
        case GLFW_KEY_INSERT:
            return "Insert";
        case GLFW_KEY_DELETE:
            return "Delete";
        case GLFW_KEY_PAGE_UP:
            return "Page up";
        case GLFW_KEY_PAGE_DOWN:
            return "Page down";
        case GLFW_KEY_END:
            return "End";
        case GLFW_KEY_KP_ADD:
            return "Keypad +";
        case GLFW_KEY_KP_SUBTRACT:
            return "Keypad -";
        default:
            break;
    }
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) {
        return fmt::format("F{}", key - GLFW_KEY_F1 + 1);
    }
    // Printable keys have their ASCII code.
    return key > GLFW_KEY_SPACE && key < 127 ? std::string(1, static_cast<char>(key)) : fmt::format("Key {}", key);
}

}  // namespace

std::string text(const Chord& chord) {
    std::string name;
    if (chord.key == 0) {
        return name;
    }
    if ((chord.modifiers & kCtrl) != 0) {
        name += "Ctrl+";
    }
    if ((chord.modifiers & GLFW_MOD_ALT) != 0) {
        name += "Alt+";
    }
    if ((chord.modifiers & GLFW_MOD_SUPER) != 0) {
        name += "Super+";
    }
    if ((chord.modifiers & kShift) != 0) {
        if (chord.key == GLFW_KEY_EQUAL) {
            return name + "+";  // The character that Shift makes of it.
        }
        name += "Shift+";
    }
    return name + key_name(chord.key);
}

std::span<const ActionInfo> actions() {
    return kActions;
}

std::optional<glm::dvec3> looks_from(Action action) {
    const auto* found = std::ranges::find(kActions, action, &ActionInfo::action);
    return found == kActions.end() ? std::nullopt : found->from;
}

}  // namespace ui
