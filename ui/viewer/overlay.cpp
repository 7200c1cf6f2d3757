#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "ui/viewer/panels.h"

namespace ui {

namespace {

/// A strip along the upper edge of the picture. Gives its height.
float banner(const Rectangle& place, float top, const ImVec4& color, const std::string& text, const Fonts& fonts,
             float scale) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float padding = 8 * scale;
    const float wrap = std::max(place.size.x - 2 * padding, 1.0F);
    const ImFont& font = *fonts.text;
    const float height = font.CalcTextSizeA(font.FontSize, FLT_MAX, wrap, text.c_str()).y + 2 * padding;
    const ImVec2 corner{place.corner.x, place.corner.y + top};
    list.AddRectFilled(corner, {place.corner.x + place.size.x, corner.y + height}, ImGui::GetColorU32(color));
    list.AddText(&font, font.FontSize, {corner.x + padding, corner.y + padding}, IM_COL32_WHITE, text.c_str(), nullptr,
                 wrap);
    return height;
}

std::string explanation(const CallAt& call) {
    const char* const colors = call.name == "intersection" ? "kept is green, lost of its operands red"
                                                           : "removed is red, the rest of what it subtracts gray";
    return fmt::format("What {}() in line {} of {} does: {}. Esc shows the model again.", call.name, call.line,
                       std::filesystem::path(call.file).filename().string(), colors);
}

/// The directions of x, y and z in the lower left corner of the picture.
void axes(const Rectangle& place, const base::Camera& camera, const Fonts& fonts, float scale) {
    struct Axis {
        glm::dvec3 direction;  ///< In eye coordinates.
        const char* name;
        ImU32 color;
    };
    const glm::dmat3 turn(camera.eye_from_world());
    std::array<Axis, 3> all{{{turn[0], "x", IM_COL32(214, 60, 56, 255)},
                             {turn[1], "y", IM_COL32(76, 163, 62, 255)},
                             {turn[2], "z", IM_COL32(62, 116, 220, 255)}}};
    std::sort(all.begin(), all.end(), [](const Axis& a, const Axis& b) { return a.direction.z < b.direction.z; });
    const float length = 30 * scale;
    const ImVec2 origin{place.corner.x + 52 * scale, place.corner.y + place.size.y - 52 * scale};
    if (place.size.x < 160 * scale || place.size.y < 160 * scale) {
        return;
    }
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImFont& font = *fonts.bold;
    for (const Axis& axis : all) {
        const float x = static_cast<float>(axis.direction.x), y = static_cast<float>(-axis.direction.y);
        list.AddLine(origin, {origin.x + length * x, origin.y + length * y}, axis.color, 2 * scale);
        const ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, axis.name);
        list.AddText(
            &font, font.FontSize,
            {origin.x + (length + 9 * scale) * x - 0.5F * size.x, origin.y + (length + 9 * scale) * y - 0.5F * size.y},
            axis.color, axis.name);
    }
}

}  // namespace

void draw_overlay(const Rectangle& place, const Session& session, const PictureInfo& picture, const Fonts& fonts,
                  float scale) {
    if (place.empty()) {
        return;
    }
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({place.corner.x, place.corner.y}, {place.corner.x + place.size.x, place.corner.y + place.size.y});
    // The legend of numbered parts lies where the axes would.
    const bool legend = session.annotations() && session.annotations()->callouts;
    if (session.shown().axes && !legend) {
        axes(place, session.view().picture.camera, fonts, scale);
    }
    float top = 0;
    const Document& document = session.document();
    if (const std::string trouble = document.trouble(); !trouble.empty()) {
        const bool gone = document.state() == DocumentState::Gone;
        top += banner(place, top, gone ? theme::kGoneBanner : theme::kErrorBanner, trouble, fonts, scale);
    }
    if (const auto& call = document.source().explained; call && document.state() == DocumentState::Good) {
        top += banner(place, top, theme::kNoteBanner, explanation(*call), fonts, scale);
    }
    if (const auto& before = document.source().before; before && document.state() == DocumentState::Good) {
        top +=
            banner(place, top, theme::kNoteBanner,
                   fmt::format("What has changed since {}: new is green, what is gone red, what has stayed gray. Esc "
                               "shows the model again.",
                               before->name),
                   fonts, scale);
    }
    if (!picture.error.empty()) {
        banner(place, top, theme::kErrorBanner, "The picture cannot be drawn: " + picture.error, fonts, scale);
    }
    list.PopClipRect();
}

}  // namespace ui
