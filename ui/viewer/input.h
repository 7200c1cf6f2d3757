// What the mouse and the keyboard did, in the order in which it happened.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "ui/viewer/commands.h"

namespace ui {

enum class PointerKind { Press, Release, Move, Scroll };
enum class Button { None, Left, Right, Middle };

/// Positions are in units of the window, from its upper left corner, y down.
struct PointerEvent {
    PointerKind kind = PointerKind::Move;
    glm::dvec2 position{0};
    Button button = Button::None;
    int modifiers = 0;  ///< That are held, of a press; GLFW's.
    double amount = 0;  ///< Of a scroll: notches, up is positive.
    double time = 0;    ///< Seconds.
};

struct KeyEvent {
    Chord chord;
    int key = 0;  ///< By its place, as GLFW numbers it.
};

struct Input {
    std::vector<PointerEvent> pointer;
    std::vector<KeyEvent> keys;        ///< Pressed, or repeated.
    std::vector<std::string> dropped;  ///< Paths of files.
    glm::dvec2 cursor{0};              ///< Where the pointer was last.
    bool any = false;    ///< Something happened that the interface may show, if only that it was uncovered.
    bool other = false;  ///< Something that is neither the pointer nor a key of these: text, focus, size.
};

}  // namespace ui
