// What mouse and keys do in the text.
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "ui/viewer/text_panel.h"

namespace ui {

namespace {

constexpr std::array kEditingKeys{GLFW_KEY_LEFT,      GLFW_KEY_RIGHT,  GLFW_KEY_UP,      GLFW_KEY_DOWN,
                                  GLFW_KEY_HOME,      GLFW_KEY_END,    GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN,
                                  GLFW_KEY_BACKSPACE, GLFW_KEY_DELETE, GLFW_KEY_ENTER,   GLFW_KEY_KP_ENTER,
                                  GLFW_KEY_TAB};

/// ImGui 1.86 numbers keys as GLFW does.
bool pressed(int key) {
    return ImGui::IsKeyPressed(key);
}

/// UTF-8 of what was typed, without control characters.
std::string typed_text() {
    std::string text;
    for (const ImWchar each : ImGui::GetIO().InputQueueCharacters) {
        const auto c = static_cast<unsigned>(each);
        if (c < 32 || c == 127) {
            continue;
        }
        if (c < 0x80) {
            text += static_cast<char>(c);
        } else if (c < 0x800) {
            text += static_cast<char>(0xC0U | (c >> 6U));
            text += static_cast<char>(0x80U | (c & 0x3FU));
        } else {
            text += static_cast<char>(0xE0U | (c >> 12U));
            text += static_cast<char>(0x80U | ((c >> 6U) & 0x3FU));
            text += static_cast<char>(0x80U | (c & 0x3FU));
        }
    }
    return text;
}

}  // namespace

bool TextPanel::uses(const Chord& chord) {
    const bool control = (chord.modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0;
    if (std::find(kEditingKeys.begin(), kEditingKeys.end(), chord.key) != kEditingKeys.end()) {
        return true;
    }
    if (control) {
        return chord.modifiers == GLFW_MOD_CONTROL &&
               (chord.key == 'A' || chord.key == 'C' || chord.key == 'X' || chord.key == 'V');
    }
    return chord.key < GLFW_KEY_ESCAPE || (chord.key >= GLFW_KEY_KP_0 && chord.key <= GLFW_KEY_KP_EQUAL);
}

bool TextPanel::press_motions(int page) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool word = io.KeyCtrl;
    const std::array<std::pair<int, TextCaret::Way>, 6> keys{
        {{GLFW_KEY_LEFT, word ? TextCaret::Way::WordLeft : TextCaret::Way::Left},
         {GLFW_KEY_RIGHT, word ? TextCaret::Way::WordRight : TextCaret::Way::Right},
         {GLFW_KEY_UP, TextCaret::Way::Up},
         {GLFW_KEY_DOWN, TextCaret::Way::Down},
         {GLFW_KEY_HOME, word ? TextCaret::Way::Begin : TextCaret::Way::LineBegin},
         {GLFW_KEY_END, word ? TextCaret::Way::End : TextCaret::Way::LineEnd}}};
    bool any = false;
    for (const auto& [key, way] : keys) {
        if (pressed(key)) {
            caret_.move(text_, way, io.KeyShift);
            any = true;
        }
    }
    for (const auto& [key, way] :
         {std::pair(GLFW_KEY_PAGE_UP, TextCaret::Way::Up), std::pair(GLFW_KEY_PAGE_DOWN, TextCaret::Way::Down)}) {
        if (pressed(key)) {
            caret_.move(text_, way, io.KeyShift, page);
            any = true;
        }
    }
    return any;
}

bool TextPanel::press_edits() {
    const ImGuiIO& io = ImGui::GetIO();
    if (pressed(GLFW_KEY_BACKSPACE)) {
        caret_.erase(text_, io.KeyCtrl ? TextCaret::Way::WordLeft : TextCaret::Way::Left);
    } else if (pressed(GLFW_KEY_DELETE)) {
        caret_.erase(text_, io.KeyCtrl ? TextCaret::Way::WordRight : TextCaret::Way::Right);
    } else if (pressed(GLFW_KEY_ENTER) || pressed(GLFW_KEY_KP_ENTER)) {
        caret_.new_line(text_);
    } else if (pressed(GLFW_KEY_TAB)) {
        caret_.indent(text_, io.KeyShift);
    } else if (io.KeyCtrl && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_A))) {
        caret_.select(0, text_.size());
    } else if (io.KeyCtrl && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_V))) {
        const char* const pasted = ImGui::GetClipboardText();
        caret_.insert(text_, pasted != nullptr ? pasted : "");
    } else if (io.KeyCtrl && caret_.selects() &&
               (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_C)) ||
                ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_X)))) {
        ImGui::SetClipboardText(text_.substr(caret_.begin(), caret_.end() - caret_.begin()).c_str());
        if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_X))) {
            caret_.insert(text_, "");
        }
    } else {
        return false;
    }
    return true;
}

bool TextPanel::type(int page) {
    const bool moved = press_motions(page), edited = press_edits();
    const std::string typed = ImGui::GetIO().KeyCtrl ? "" : typed_text();
    if (!typed.empty()) {
        caret_.insert(text_, typed);
    }
    return moved || edited || !typed.empty();
}

void TextPanel::point(float left, float top, float row, Commands& commands) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool over = ImGui::IsWindowHovered();
    const auto line =
        static_cast<std::size_t>(std::clamp((io.MousePos.y - top) / row, 0.0F, static_cast<float>(starts_.size()) - 1));
    if (over && editable_) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    }
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        // Not on a scroll bar.
        const ImVec2 corner = ImGui::GetWindowPos(), room = ImGui::GetContentRegionAvail();
        const bool inside = io.MousePos.x < corner.x + room.x && io.MousePos.y < corner.y + ImGui::GetWindowHeight();
        focused_ = over && editable_ && inside;
        drags_ = focused_;
        if (focused_) {
            const std::size_t at = byte_at(line, io.MousePos.x - left);
            caret_.put(at, io.KeyShift);
            moved_at_ = ImGui::GetTime();
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
                caret_.select_word(text_, at);
                drags_ = false;
            } else if (!io.KeyShift) {
                commands.emplace_back(SelectByte{at});
            }
        }
    } else if (drags_ && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
        caret_.put(byte_at(line, io.MousePos.x - left), true);
        follows_ = true;
    }
    drags_ = drags_ && ImGui::IsMouseDown(ImGuiMouseButton_Left);
}

}  // namespace ui
