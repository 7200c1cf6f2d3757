#include <imgui.h>

#include <array>

#include <fmt/format.h>

#include "ui/viewer/inspection_panel.h"
#include "ui/viewer/panel_window.h"

namespace ui {

namespace {

struct Choice {
    const char* label;
    std::optional<ThicknessRequest> request;
};

std::array<Choice, 5> choices() {
    using What = ThicknessRequest::What;
    return {{{"Colors of the model", std::nullopt},
             {"Walls, across faces", ThicknessRequest{What::Wall, false, {}}},
             {"Gaps, across faces", ThicknessRequest{What::Gap, false, {}}},
             {"Walls, along the view", ThicknessRequest{What::Wall, true, {}}},
             {"Gaps, along the view", ThicknessRequest{What::Gap, true, {}}}}};
}

bool same_map(std::optional<ThicknessRequest> a, std::optional<ThicknessRequest> b) {
    for (auto* each : {&a, &b}) {
        if (*each) {
            (*each)->range.reset();
        }
    }
    return a == b;
}

void thin_places(const InspectionView& view, Commands& commands) {
    const auto& map = view.inspection.thickness();
    if (!map) {
        return;
    }
    if (map->places.empty()) {
        ImGui::TextDisabled("no two opposite faces are to be seen");
        return;
    }
    ImGui::Dummy({0, 0.25F * ImGui::GetFontSize()});
    bold_text("Thinnest places that are seen", view.fonts);
    for (std::size_t i = 0; i < map->places.size(); ++i) {
        const InspectedPlace place = view.inspection.thin_place(i, view.session.document());
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable(fmt::format("{:.4g} mm", map->places[i].value).c_str(), false)) {
            ask(commands, ShowThinPlace{i});
        }
        ImGui::SameLine(7 * ImGui::GetFontSize());
        ImGui::TextDisabled("%s", place.place.c_str());
        ImGui::PopID();
    }
}

}  // namespace

void ThicknessTab::draw(const InspectionView& view, Commands& commands) {
    const auto& shown = view.session.view().thickness;
    const auto want = [&](std::optional<ThicknessRequest> wanted) {
        if (wanted) {
            wanted->range = fixed_ ? std::optional(range_) : std::nullopt;
        }
        ask(commands, SetThickness{wanted});
    };
    for (const Choice& choice : choices()) {
        if (ImGui::RadioButton(choice.label, same_map(shown, choice.request))) {
            want(choice.request);
        }
    }
    if (!shown) {
        return;
    }
    bool changed = ImGui::Checkbox("Blue begins at", &fixed_);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(5 * ImGui::GetFontSize());
    changed |= ImGui::InputDouble("mm", &range_, 0, 0, "%.4g") && fixed_;
    range_ = range_ > 0 ? range_ : 1;
    if (changed) {
        want(shown);
    }
    thin_places(view, commands);
}

}  // namespace ui
