#include <imgui.h>

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "ui/viewer/inspection_panel.h"
#include "ui/viewer/panel_window.h"

namespace ui {

namespace {

struct Row {
    const char* name;
    std::string value;
};

/// "9015 ± 60": in as many digits as the error leaves.
std::string with_error(double value, double error) {
    const double least = std::max(error, 1e-6 * std::abs(value));
    const int digits = least > 0 ? std::clamp(static_cast<int>(std::ceil(1 - std::log10(least))), 0, 6) : 3;
    return error > 0 ? fmt::format("{:.{}f} ± {:.2g}", value, digits, error) : fmt::format("{:.6g}", value);
}

std::string point(const glm::dvec3& p) {
    return fmt::format("{:.5g}, {:.5g}, {:.5g}", p.x, p.y, p.z);
}

std::vector<Row> rows(const SolidMeasures& m) {
    if (!(m.volume.value > 0)) {
        return {{"Volume", "no ray has met it"}};
    }
    const glm::dvec3 size = m.box.size();
    return {{"Volume", with_error(m.volume.value, m.volume.error) + " mm³"},
            {"Area", with_error(m.area.value, m.area.error) + " mm²"},
            {"Centroid", point(m.centroid) + fmt::format(" ± {:.2g}", m.centroid_error)},
            {"Size", fmt::format("{:.5g} × {:.5g} × {:.5g} mm", size.x, size.y, size.z)},
            {"From", point(m.box.lo)},
            {"To", point(m.box.hi)},
            {"Moments", fmt::format("{:.4g} mm^5", m.moments.x)},
            {"of inertia", fmt::format("{:.4g}", m.moments.y)},
            {"", fmt::format("{:.4g} ± {:.2g}", m.moments.z, m.moments_error)}};
}

void table(const SolidMeasures& measures) {
    for (const Row& row : rows(measures)) {
        ImGui::TextDisabled("%s", row.name);
        ImGui::SameLine(5.2F * ImGui::GetFontSize());
        ImGui::TextUnformatted(row.value.c_str());
    }
}

}  // namespace

std::string text_of(const MeasuresAnswer& answer) {
    std::string text;
    const auto add = [&](const std::string& name, const SolidMeasures& measures) {
        text += name + '\n';
        for (const Row& row : rows(measures)) {
            text += fmt::format("  {:<10}{}\n", row.name, row.value);
        }
    };
    add("all", answer.measures.all);
    for (std::size_t i = 0; i < answer.names.size(); ++i) {
        add(answer.names[i], answer.measures.parts[i]);
    }
    return text;
}

void MeasuresTab::draw(const InspectionView& view, Commands& commands) {
    static constexpr std::array<double, 4> kPrecisions{0.01, 0.005, 0.002, 0.001};
    if (task_button("Measure", "measure", view.inspection, commands)) {
        ask(commands, RunMeasures{parts_.rule(csg::PartRule{csg::PartRule::Kind::Depth, 1, {}}),
                                  kPrecisions[static_cast<std::size_t>(precision_)]});
    }
    parts_.draw("Parts as the top-level union has them");
    ImGui::SetNextItemWidth(-1);
    ImGui::Combo("##precision", &precision_, "To 1 % of volume and area\0To 0.5 %\0To 0.2 %\0To 0.1 %\0");
    const auto& answer = view.inspection.measures();
    if (!answer) {
        return;
    }
    tell_state(*answer, view.session);
    if (!answer->error.empty()) {
        return;
    }
    if (ImGui::BeginChild("measures")) {
        bold_text("All of it", view.fonts);
        ImGui::SameLine(ImGui::GetContentRegionMax().x - 3 * ImGui::GetFontSize());
        if (ImGui::SmallButton("Copy")) {
            ask(commands, CopyText{text_of(*answer)});
        }
        table(answer->measures.all);
        for (std::size_t i = 0; i < answer->names.size() && answer->names.size() > 1; ++i) {
            ImGui::PushID(static_cast<int>(i));
            ImGui::Dummy({0, 0.25F * ImGui::GetFontSize()});
            bold_text(answer->names[i].c_str(), view.fonts);
            table(answer->measures.parts[i]);
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
}

}  // namespace ui
