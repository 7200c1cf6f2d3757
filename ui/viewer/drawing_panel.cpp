#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "npr/accumulate.h"
#include "ui/viewer/camera_control.h"
#include "ui/viewer/panel_window.h"
#include "ui/viewer/panels.h"

namespace ui {

namespace {

void heading(const char* text, const Fonts& fonts) {
    ImGui::Dummy({0, 0.25F * ImGui::GetFontSize()});
    bold_text(text, fonts);
}

/// Buttons in rows of `columns` that fill the width; calls `pressed` with the index.
template <typename Label, typename Chosen, typename Pressed>
void button_grid(std::size_t count, std::size_t columns, Label&& label, Chosen&& chosen, Pressed&& pressed) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width =
        (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    for (std::size_t i = 0; i < count; ++i) {
        if (i % columns != 0) {
            ImGui::SameLine(0, gap);
        }
        const bool is_chosen = chosen(i);
        if (is_chosen) {
            const ImVec4 color = ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive);
            ImGui::PushStyleColor(ImGuiCol_Button, color);
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, {1.12F * color.x, 1.12F * color.y, 1.12F * color.z, 1});
        }
        if (ImGui::Button(label(i).c_str(), {width, 0})) {
            pressed(i);
        }
        if (is_chosen) {
            ImGui::PopStyleColor(2);
        }
    }
}

/// The last cell of a grid of buttons: a list of the styles from `first` on.
void more_styles(const ViewState& view, std::size_t first, Commands& commands) {
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::SetNextItemWidth(-1);
    const bool one_of_them = view.style() >= first;
    const std::string shown(one_of_them ? npr::styles()[view.style()].label : "More");
    if (!ImGui::BeginCombo("##more", shown.c_str(), ImGuiComboFlags_HeightLarge)) {
        return;
    }
    for (std::size_t i = first; i < npr::styles().size(); ++i) {
        if (ImGui::Selectable(std::string(npr::styles()[i].label).c_str(), i == view.style())) {
            commands.emplace_back(SetStyle{i});
        }
    }
    ImGui::EndCombo();
}

void style_section(const ViewState& view, const Fonts& fonts, Commands& commands) {
    constexpr std::size_t kColumns = 3, kButtons = 2 * kColumns - 1;
    heading("Style", fonts);
    button_grid(
        kButtons, kColumns, [](std::size_t i) { return std::string(npr::styles()[i].label); },
        [&](std::size_t i) { return i == view.style(); }, [&](std::size_t i) { commands.emplace_back(SetStyle{i}); });
    more_styles(view, kButtons, commands);
    const npr::Parameters& values = view.picture.parameters;
    ImGui::PushID(static_cast<int>(view.style()));  // Parameters of two styles may have the same name.
    for (std::size_t i = 0; i < values.list().size(); ++i) {
        npr::Value value = values.at(i);
        if (draw_parameter(values.list()[i], value)) {
            commands.emplace_back(SetParameter{i, value});
        }
    }
    if (!values.list().empty() && ImGui::Button("Reset parameters", {-1, 0})) {
        commands.emplace_back(ResetParameters{});
    }
    ImGui::PopID();
}

void swatch(const glm::vec3& color) {
    ImGui::ColorButton("##swatch", {color.r, color.g, color.b, 1},
                       ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop | ImGuiColorEditFlags_NoBorder,
                       {ImGui::GetFontSize(), ImGui::GetFontSize()});
    ImGui::SameLine(0, 2);
}

void scheme_section(const ViewState& view, const Fonts& fonts, Commands& commands) {
    heading("Color scheme", fonts);
    ImGui::SetNextItemWidth(-1);
    const std::string shown(view.picture.scheme.name);
    if (!ImGui::BeginCombo("##scheme", shown.c_str(), ImGuiComboFlags_HeightLarge)) {
        return;
    }
    for (std::size_t i = 0; i < npr::color_schemes().size(); ++i) {
        const npr::ColorScheme& scheme = npr::color_schemes()[i];
        ImGui::PushID(static_cast<int>(i));
        swatch(scheme.background);
        swatch(scheme.face);
        swatch(scheme.cut);
        ImGui::SameLine(0, ImGui::GetStyle().ItemSpacing.x);
        if (ImGui::Selectable(std::string(scheme.name).c_str(), scheme == view.picture.scheme)) {
            commands.emplace_back(SetScheme{i});
        }
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

void transparency_section(const ViewState& view, const Fonts& fonts, Commands& commands) {
    heading("Transparency", fonts);
    const auto models = npr::transparencies();
    const auto shown = std::find_if(models.begin(), models.end(),
                                    [&](const auto& each) { return each.model == view.picture.transparency; });
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##transparency", std::string(shown->label).c_str())) {
        for (const npr::TransparencyInfo& each : models) {
            if (ImGui::Selectable(std::string(each.label).c_str(), each.model == shown->model)) {
                commands.emplace_back(SetTransparency{each.model});
            }
        }
        ImGui::EndCombo();
    }
    const npr::Parameters& values = view.picture.transparency_parameters;
    ImGui::PushID("transparency");
    for (std::size_t i = 0; i < values.list().size(); ++i) {
        npr::Value value = values.at(i);
        if (draw_parameter(values.list()[i], value)) {
            commands.emplace_back(SetTransparencyParameter{i, value});
        }
    }
    ImGui::PopID();
}

void layers_section(const Session& session, const Fonts& fonts, Commands& commands) {
    heading("Layers", fonts);
    const int layers = session.view().picture.layers;
    bool automatic = layers < 0;
    if (ImGui::Checkbox("As the style needs", &automatic)) {
        commands.emplace_back(SetLayers{automatic ? -1 : 0});
    }
    if (layers < 0) {
        return;
    }
    // 1 … n, and beyond its end all.
    const int all = session.layer_count() + 1;
    int position = layers == 0 || layers >= all ? all : layers;
    ImGui::SetNextItemWidth(-1);
    const char* format = position == all ? "all" : "the first %d";
    if (ImGui::SliderInt("##layers", &position, 1, all, format, ImGuiSliderFlags_AlwaysClamp)) {
        commands.emplace_back(SetLayers{position == all ? 0 : position});
    }
}

/// The axis of a section that is one plane across it; none of others.
std::optional<int> section_axis(const npr::Sections& sections) {
    const auto* plane = sections.cuts.size() == 1 ? std::get_if<npr::PlaneSection>(&sections.cuts[0].cut) : nullptr;
    for (int axis = 0; plane != nullptr && axis < 3; ++axis) {
        if (std::abs(plane->normal[axis]) == 1) {
            return axis;
        }
    }
    return std::nullopt;
}

/// Slider and side of a plane across an axis.
void plane_controls(const npr::Sections& sections, int axis, const csg::Box& box, Commands& commands) {
    npr::Sections moved = sections;
    auto& plane = std::get<npr::PlaneSection>(moved.cuts[0].cut);
    auto at = static_cast<float>(plane.normal[axis] * plane.offset);
    ImGui::SetNextItemWidth(-1);
    const std::string format = fmt::format("{} = %.4g", "xyz"[axis]);
    if (ImGui::SliderFloat("##section", &at, static_cast<float>(box.lo[axis]), static_cast<float>(box.hi[axis]),
                           format.c_str(), ImGuiSliderFlags_AlwaysClamp)) {
        plane.offset = plane.normal[axis] * at;
        commands.emplace_back(SetSections{moved});
    }
    if (ImGui::Button("Cut the other side", {-1, 0})) {
        plane.normal = -plane.normal;
        plane.offset = -plane.offset;
        commands.emplace_back(SetSections{moved});
    }
}

void section_section(const Session& session, const Fonts& fonts, Commands& commands) {
    heading("Section", fonts);
    const npr::Sections& sections = session.view().picture.sections;
    const auto& model = session.document().model();
    if (!model || model->empty()) {
        ImGui::TextDisabled("there is nothing to cut");
        return;
    }
    const csg::Box& box = model->box;
    const std::optional<int> axis = section_axis(sections);
    const bool quarter = sections.cuts.size() == 1 && std::holds_alternative<npr::BoxSection>(sections.cuts[0].cut);
    constexpr std::size_t kOff = 0, kQuarter = 4;
    button_grid(
        5, 5,
        [](std::size_t i) {
            return std::string(std::array{"Off", "X", "Y", "Z", "1/4"}[i]);
        },
        [&](std::size_t i) {
            return i == kOff       ? sections.cuts.empty()
                   : i == kQuarter ? quarter
                                   : axis && i == static_cast<std::size_t>(*axis) + 1;
        },
        [&](std::size_t i) {
            npr::Sections wanted{{}, sections.uncut, sections.spacing};
            if (i == kQuarter) {
                wanted.cuts.push_back({npr::CornerSection{2}, "quarter"});
            } else if (i != kOff) {
                npr::PlaneSection plane{glm::dvec3(0.0), box.center()[static_cast<int>(i) - 1]};
                plane.normal[static_cast<int>(i) - 1] = 1;
                wanted.cuts.push_back({plane, "plane"});
            }
            commands.emplace_back(SetSections{wanted});
        });
    if (axis) {
        plane_controls(sections, *axis, box, commands);
    }
    bool hatching = sections.spacing != 0;
    if (!sections.cuts.empty() && ImGui::Checkbox("Hatching", &hatching)) {
        npr::Sections wanted = sections;
        wanted.spacing = hatching ? npr::Sections::kOwnSpacing : 0;
        commands.emplace_back(SetSections{wanted});
    }
}

void samples_section(const ViewState& view, const Fonts& fonts, Commands& commands) {
    heading("Samples per pixel", fonts);
    button_grid(
        npr::kSampleCounts.size(), npr::kSampleCounts.size(),
        [](std::size_t i) { return std::to_string(npr::kSampleCounts[i]); },
        [&](std::size_t i) { return npr::kSampleCounts[i] == view.picture.samples; },
        [&](std::size_t i) { commands.emplace_back(SetSamples{npr::kSampleCounts[i]}); });
}

void camera_section(const ViewState& view, const Fonts& fonts, Commands& commands) {
    struct Entry {
        const char* label;
        Action action;
    };
    static constexpr std::array<Entry, 9> kEntries{{{"Top", Action::Top},
                                                    {"Bottom", Action::Bottom},
                                                    {"Diagonal", Action::Diagonal},
                                                    {"Left", Action::Left},
                                                    {"Right", Action::Right},
                                                    {"View all", Action::ViewAll},
                                                    {"Front", Action::Front},
                                                    {"Back", Action::Back},
                                                    {"Reset", Action::ResetView}}};
    heading("Camera", fonts);
    const auto chosen = [&](std::size_t i) { return looks_from(kEntries[i].action) == view.picture.camera.rotation; };
    button_grid(
        kEntries.size(), 3, [](std::size_t i) { return std::string(kEntries[i].label); }, chosen,
        [&](std::size_t i) { commands.emplace_back(kEntries[i].action); });
    const bool orthographic = view.picture.camera.projection == base::Projection::Orthographic;
    button_grid(
        2, 2, [](std::size_t i) { return std::string(i == 0 ? "Perspective" : "Orthographic"); },
        [&](std::size_t i) { return orthographic == (i == 1); },
        [&](std::size_t i) {
            if (orthographic != (i == 1)) {
                commands.emplace_back(Action::ToggleProjection);
            }
        });
}

void figure(const char* name, const std::string& value) {
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine(6.5F * ImGui::GetFontSize());
    ImGui::TextUnformatted(value.c_str());
}

void model_section(const Session& session, const Fonts& fonts) {
    heading("Model", fonts);
    const auto& model = session.document().model();
    if (!model || model->empty()) {
        ImGui::TextDisabled("%s", model ? "nothing to see" : "none yet");
        return;
    }
    const ModelStatistics& s = model->statistics;
    const glm::dvec3 size = model->box.size();
    figure("Leaves", fmt::format("{} in {} part{}", s.leaves, s.parts, s.parts == 1 ? "" : "s"));
    figure("Products", fmt::format("{} of {} literals", s.products, s.literals));
    figure("Triangles", fmt::format("{}", s.triangles));
    figure("Size", fmt::format("{:.4g} × {:.4g} × {:.4g}", size.x, size.y, size.z));
    figure("Evaluated in", fmt::format("{:.0f} ms", session.document().milliseconds()));
}

/// Who drew it, and what was left out.
void picture_section(const PictureInfo& picture, const Fonts& fonts) {
    if (picture.samples == 0) {
        return;
    }
    const goldfeather::WalkStats& walk = picture.walk;
    // Counts are sums over the samples.
    const auto each = [&](std::uint64_t count) { return count / static_cast<std::uint64_t>(picture.samples); };
    heading("Picture", fonts);
    figure("Engine", std::string(picture.engine.engine->name));
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", picture.engine.reason.c_str());
    ImGui::PopTextWrapPos();
    figure("Layers", fmt::format("{}", walk.layers));
    std::string leaves = fmt::format("{} out of view", each(walk.skipped_leaves));
    if (walk.occluded_leaves) {
        leaves += fmt::format(", {} not seen", each(*walk.occluded_leaves));
    }
    figure("Leaves", leaves);
    if (picture.engine.engine->capabilities.needs_products) {
        figure("Products", fmt::format("{} out of view", each(walk.skipped_products)));
    } else if (!picture.engine.engine->capabilities.needs_opengl) {
        figure("Triangles", fmt::format("{} cover no sample", each(walk.skipped_triangles)));
    }
}

}  // namespace

void draw_panel(const Rectangle& place, const Session& session, const PictureInfo& picture, const Fonts& fonts,
                Commands& commands) {
    if (place.empty()) {
        return;
    }
    if (begin_panel("Drawing", place)) {
        style_section(session.view(), fonts, commands);
        scheme_section(session.view(), fonts, commands);
        transparency_section(session.view(), fonts, commands);
        draw_media(session, commands);
        layers_section(session, fonts, commands);
        section_section(session, fonts, commands);
        samples_section(session.view(), fonts, commands);
        camera_section(session.view(), fonts, commands);
        model_section(session, fonts);
        picture_section(picture, fonts);
    }
    ImGui::End();
}

}  // namespace ui
