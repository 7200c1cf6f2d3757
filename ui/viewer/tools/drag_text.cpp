#include "ui/viewer/tools/drag_text.h"

#include <GLFW/glfw3.h>

#include "ui/viewer/tool.h"

namespace ui {

bool type_number(const KeyEvent& event, std::string& typed) {
    const int key = event.chord.key;
    if (key == GLFW_KEY_BACKSPACE) {
        if (!typed.empty()) {
            typed.pop_back();
        }
    } else if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) {
        typed += static_cast<char>('0' + key - GLFW_KEY_KP_0);
    } else if (key == GLFW_KEY_KP_SUBTRACT || key == GLFW_KEY_KP_DECIMAL) {
        typed += key == GLFW_KEY_KP_DECIMAL ? '.' : '-';
    } else if ((key >= '0' && key <= '9') || key == '-' || key == '.' || key == ',') {
        typed += static_cast<char>(key);
    } else {
        return false;
    }
    return true;
}

bool ends_drag(const KeyEvent& event) {
    return event.chord.key == GLFW_KEY_ENTER || event.chord.key == GLFW_KEY_KP_ENTER;
}

void draw_drag_text(const std::string& words, const glm::dvec2& pointer, const ToolPainter& painter) {
    const ImFont& font = *painter.fonts.mono;
    const ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, words.c_str());
    const float padding = 6 * painter.scale;
    const ImVec2 corner{static_cast<float>(pointer.x) + 18 * painter.scale,
                        static_cast<float>(pointer.y) + 14 * painter.scale};
    painter.list.AddRectFilled(corner, {corner.x + size.x + 2 * padding, corner.y + size.y + 2 * padding},
                               IM_COL32(24, 27, 31, 235), 4 * painter.scale);
    painter.list.AddText(&font, font.FontSize, {corner.x + padding, corner.y + padding}, IM_COL32_WHITE, words.c_str());
}

}  // namespace ui
