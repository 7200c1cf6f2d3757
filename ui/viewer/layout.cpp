#include "ui/viewer/layout.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// Windows smaller than these, on a common display, have no panel, and no console.
constexpr glm::vec2 kLeastForPanel{480, 200};
constexpr float kLeastForConsole = 320;
/// What the left panel leaves the picture at least.
constexpr float kLeastPicture = 240;

}  // namespace

Layout make_layout(glm::vec2 window, float menu_height, float scale, const Shown& shown, float console_height) {
    const auto whole = [](float length) { return std::max(0.0F, std::floor(length)); };
    const float top = whole(menu_height);
    const float status_height = std::min(whole(26 * scale), whole(window.y - top));
    const float bottom = window.y - status_height;
    // In a small window the picture needs all the room.
    const bool panel = (shown.panel || shown.inspection || shown.dynamics) && window.x >= kLeastForPanel.x * scale &&
                       window.y >= kLeastForPanel.y * scale;
    const float panel_width = panel ? whole(std::min(310 * scale, window.x * 2 / 3)) : 0;
    const float left_width =
        shown.text || shown.tree ? whole(std::max(290 * scale, 0.33F * window.x)) : whole(290 * scale);
    const bool has_left = (shown.customizer || shown.text || shown.tree) && window.y >= kLeastForPanel.y * scale &&
                          window.x - panel_width - left_width >= kLeastPicture * scale;
    const float left = has_left ? left_width : 0;
    const float right = window.x - panel_width;
    const float most = whole((bottom - top) * 2 / 3);
    const float least = std::min(60 * scale, most);
    const bool open = shown.console && window.y >= kLeastForConsole * scale;
    const float console = open ? whole(std::clamp(console_height, least, most)) : 0;

    const float below = bottom - console;
    const float animation = shown.animation ? std::min(whole(40 * scale), std::max(0.0F, below - top)) : 0;

    Layout layout;
    layout.picture = {{left, top}, {right - left, std::max(0.0F, below - animation - top)}};
    layout.animation = {{left, below - animation}, {right - left, animation}};
    layout.console = {{left, bottom - console}, {right - left, console}};
    layout.panel = {{right, top}, {panel_width, std::max(0.0F, bottom - top)}};
    layout.left = {{0, top}, {left, std::max(0.0F, bottom - top)}};
    layout.status = {{0, bottom}, {window.x, status_height}};
    return layout;
}

}  // namespace ui
