#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include <fmt/format.h>

#include "ui/viewer/inspection_panel.h"
#include "ui/viewer/panel_window.h"

namespace ui {

namespace {

constexpr csg::PartRule kWhole{csg::PartRule::Kind::Model, 1, {}}, kTop{csg::PartRule::Kind::Depth, 1, {}};

void number(const char* id, double& value, double least) {
    ImGui::SetNextItemWidth(4.2F * ImGui::GetFontSize());
    ImGui::InputDouble(id, &value, 0, 0, "%.5g");
    value = std::max(value, least);
}

/// A check with its limit at the right.
void limit_row(const char* label, const char* unit, bool& on, double& value, double least) {
    ImGui::PushID(label);
    ImGui::Checkbox(label, &on);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 7.4F * ImGui::GetFontSize());
    number(unit, value, least);
    ImGui::PopID();
}

}  // namespace

CheckRequest ChecksTab::request() const {
    const auto of = [](const Limit& limit) { return limit.on ? std::optional(limit.value) : std::nullopt; };
    CheckRequest request;
    request.min_wall = of(wall_);
    request.min_gap = of(gap_);
    request.min_feature = of(feature_);
    request.interference = of(interference_);
    request.max_overhang = of(overhang_);
    request.min_volume = of(least_volume_);
    request.max_volume = of(most_volume_);
    request.no_effect = no_effect_;
    request.coincident = coincident_;
    if (sized_) {
        request.max_size = glm::dvec3(size_[0], size_[1], size_[2]);
    }
    std::copy_if(clearances_.begin(), clearances_.end(), std::back_inserter(request.clearances),
                 [](const Clearance& each) { return !each.a.empty() && !each.b.empty(); });
    return request;
}

bool ChecksTab::asks() const {
    const CheckRequest r = request();
    return r.min_wall || r.min_gap || r.min_feature || r.interference || r.max_overhang || r.min_volume ||
           r.max_volume || r.no_effect || r.coincident || r.max_size || !r.clearances.empty();
}

void ChecksTab::limits() {
    constexpr double kLeast = 1e-6;
    limit_row("Walls thinner than", "mm", wall_.on, wall_.value, kLeast);
    limit_row("Gaps narrower than", "mm", gap_.on, gap_.value, kLeast);
    limit_row("Pins, holes less than", "mm", feature_.on, feature_.value, kLeast);
    limit_row("Overhangs beyond", "deg", overhang_.on, overhang_.value, 0);
    limit_row("Parts overlapping by", "mm", interference_.on, interference_.value, 0);
    clearances();
    ImGui::Checkbox("Operations without effect", &no_effect_);
    ImGui::Checkbox("Faces that only touch", &coincident_);
    limit_row("Volume below", "mm3", least_volume_.on, least_volume_.value, 0);
    limit_row("Volume above", "mm3", most_volume_.on, most_volume_.value, 0);
    ImGui::Checkbox("Size over", &sized_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ImGui::SameLine(axis == 0 ? ImGui::GetContentRegionMax().x - 12.9F * ImGui::GetFontSize() : 0, 3);
        ImGui::PushID(static_cast<int>(axis));
        ImGui::SetNextItemWidth(3.4F * ImGui::GetFontSize());
        ImGui::InputDouble(axis == 2 ? "mm" : "##size", &size_[axis], 0, 0, "%.5g");
        size_[axis] = std::max(size_[axis], kLeast);
        ImGui::PopID();
    }
}

/// Two names and the least distance of each, and room for one more.
void ChecksTab::clearances() {
    if (ImGui::SmallButton("Add two parts that keep a distance")) {
        clearances_.push_back({"", "", 1});
    }
    for (std::size_t i = 0; i < clearances_.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const float width = 5.2F * ImGui::GetFontSize();
        ImGui::SetNextItemWidth(width);
        ImGui::InputTextWithHint("##a", "part", &clearances_[i].a);
        ImGui::SameLine(0, 3);
        ImGui::SetNextItemWidth(width);
        ImGui::InputTextWithHint("##b", "part", &clearances_[i].b);
        ImGui::SameLine(0, 3);
        number("mm", clearances_[i].least, 1e-6);
        ImGui::SameLine(0, 3);
        const bool gone = ImGui::SmallButton("x");
        ImGui::PopID();
        if (gone) {
            clearances_.erase(clearances_.begin() + static_cast<std::ptrdiff_t>(i));
            break;
        }
    }
}

void ChecksTab::findings(const InspectionView& view, Commands& commands) {
    const auto& checks = view.inspection.checks();
    if (!checks) {
        return;
    }
    tell_state(*checks, view.session);
    if (!checks->error.empty()) {
        return;
    }
    const std::size_t count = checks->findings.size();
    bold_text(count == 0   ? "No findings"
              : count == 1 ? "1 finding"
                           : fmt::format("{} findings", count).c_str(),
              view.fonts);
    if (checks->result.samples != 0) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled(
            "%s",
            fmt::format("What holds a disc of radius {:.3g} mm on a face is found.", checks->result.reach).c_str());
        ImGui::PopTextWrapPos();
    }
    if (ImGui::BeginChild("findings")) {
        for (std::size_t i = 0; i < count; ++i) {
            const InspectedPlace& place = checks->findings[i];
            const auto& marked = view.inspection.marked();
            const bool chosen = marked && i == clicked_ && marked->headline == place.headline;
            ImGui::PushID(static_cast<int>(i));
            const float wrap = ImGui::GetContentRegionAvail().x;
            const ImVec2 corner = ImGui::GetCursorPos();
            const ImVec2 size = ImGui::CalcTextSize(place.headline.c_str(), nullptr, false, wrap);
            const float row = ImGui::GetTextLineHeight();
            if (ImGui::Selectable("##finding", chosen, 0, {0, size.y + row})) {
                clicked_ = i;
                ask(commands, ShowFinding{i});
            }
            const ImVec2 next = ImGui::GetCursorPos();
            ImGui::SetCursorPos(corner);
            ImGui::PushTextWrapPos(0);
            ImGui::TextUnformatted(place.headline.c_str());
            ImGui::PopTextWrapPos();
            ImGui::SetCursorPos({corner.x, corner.y + size.y});
            ImGui::TextDisabled("%s", place.place.c_str());
            ImGui::SetCursorPos(next);
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
}

void ChecksTab::draw(const InspectionView& view, Commands& commands) {
    if (task_button("Check", "check", view.inspection, commands)) {
        const CheckRequest asked = request();
        const bool between_parts = asked.interference || !asked.clearances.empty();
        if (asks()) {
            ask(commands, RunChecks{asked, parts_.rule(between_parts ? kTop : kWhole)});
        }
    }
    limits();
    parts_.draw("Parts as the checks need them");
    findings(view, commands);
}

}  // namespace ui
