#include "ui/viewer/tone_legend.h"

#include <imgui.h>

#include <fmt/format.h>

#include "ui/pipeline/picture/legend.h"

namespace ui {

void draw_tone_legend(const Rectangle& place, double full, const std::function<glm::vec3(float share)>& tone,
                      const glm::vec3& ground, const Fonts& fonts, float scale) {
    if (place.size.x < 160 * scale || place.size.y < 160 * scale) {
        return;
    }
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImFont& font = *fonts.text;
    const float width = 10 * scale, height = 0.4F * place.size.y;
    const ImVec2 corner{place.corner.x + 104 * scale, place.corner.y + place.size.y - 14 * scale - height};
    const auto color_of = [](const glm::vec3& c) { return ImGui::GetColorU32(ImVec4(c.x, c.y, c.z, 1)); };
    const ImU32 ink = color_of(glm::vec3(ground.x + ground.y + ground.z > 1.5F ? 0.0F : 1.0F));
    list.AddRect({corner.x - 1, corner.y - 1}, {corner.x + width + 1, corner.y + height + 1}, ink);
    constexpr int kSteps = 64;
    for (int i = 0; i < kSteps; ++i) {
        const float share = (static_cast<float>(i) + 0.5F) / kSteps, low = corner.y + height;
        list.AddRectFilled({corner.x, low - height * static_cast<float>(i + 1) / kSteps},
                           {corner.x + width, low - height * static_cast<float>(i) / kSteps}, color_of(tone(share)));
    }
    const double step = legend_step(full);
    for (int i = 0; i * step <= full * (1 + 1e-9); ++i) {
        const float y = corner.y + height - static_cast<float>(i * step / full) * height;
        list.AddLine({corner.x + width, y}, {corner.x + width + 4 * scale, y}, ink, scale);
        list.AddText(&font, font.FontSize, {corner.x + width + 7 * scale, y - 0.5F * font.FontSize}, ink,
                     fmt::format("{:g}{}", i * step, i == 0 ? " mm" : "").c_str());
    }
}

}  // namespace ui
