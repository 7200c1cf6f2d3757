// Controls of media (volume), and the legend of radiographs.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "npr/medium_rows.h"
#include "npr/part_style.h"
#include "npr/styles/radiograph.h"
#include "ui/pipeline/picture/legend.h"
#include "ui/pipeline/picture/radiograph.h"
#include "ui/viewer/panels.h"
#include "ui/viewer/tone_legend.h"

namespace ui {

namespace {

constexpr std::size_t kMostParts = 64;  ///< That have controls.

/// What a part is made of, as far as it is said; what is not said as it follows from the part's color and opacity.
struct MediumOfPart {
    float attenuation = 0;
    glm::vec3 albedo{1};
};

MediumOfPart medium_of(const npr::Picture& picture, const csg::Part& part, double diagonal) {
    MediumOfPart result;
    const float opacity = part.color.a < 0 ? 1 : part.color.a;
    result.attenuation =
        static_cast<float>(npr::attenuation_of(std::min(opacity, 0.999F), npr::kMediumThickness * diagonal));
    for (int c = 0; c < 3; ++c) {
        const float given = c == 0 ? part.color.r : c == 1 ? part.color.g : part.color.b;
        result.albedo[c] = std::clamp(given >= 0 ? given : picture.scheme.face[c], 0.0F, 1.0F);
    }
    for (const npr::PartMedium& medium : picture.media) {
        if (npr::names_part(medium.part, part.name)) {
            result.attenuation = medium.attenuation.value_or(result.attenuation);
            result.albedo = medium.albedo.value_or(result.albedo);
        }
    }
    return result;
}

/// The media with that of a part instead of what they said of it.
std::vector<npr::PartMedium> with_medium(std::vector<npr::PartMedium> media, const npr::PartMedium& medium) {
    std::erase_if(media, [&](const npr::PartMedium& each) { return each.part == medium.part; });
    media.push_back(medium);
    return media;
}

void draw_part(const npr::Picture& picture, const csg::Part& part, double diagonal, Commands& commands) {
    MediumOfPart medium = medium_of(picture, part, diagonal);
    const bool said = std::any_of(picture.media.begin(), picture.media.end(),
                                  [&](const npr::PartMedium& each) { return npr::names_part(each.part, part.name); });
    bool is_medium = part.kind == csg::PartKind::Translucent || said;
    ImGui::PushID(part.name.c_str());
    if (part.kind == csg::PartKind::Solid && ImGui::Checkbox("##medium", &is_medium)) {
        auto media = picture.media;
        std::erase_if(media, [&](const npr::PartMedium& each) { return npr::names_part(each.part, part.name); });
        if (is_medium) {
            media.push_back({part.name, medium.attenuation, medium.albedo});
        }
        commands.emplace_back(SetMedia{std::move(media), picture.medium_light});
    }
    if (part.kind == csg::PartKind::Solid) {
        ImGui::SameLine();
    }
    bool changed = false;
    ImGui::BeginDisabled(!is_medium);
    changed = ImGui::ColorEdit3((part.name + "##albedo").c_str(), &medium.albedo.x, ImGuiColorEditFlags_NoInputs);
    ImGui::SetNextItemWidth(-1);
    const auto most = static_cast<float>(1000 / diagonal);
    changed |= ImGui::SliderFloat("##tau", &medium.attenuation, 0, most, "%.4g / mm",
                                  ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
    ImGui::EndDisabled();
    if (changed) {
        medium.albedo = glm::clamp(medium.albedo, 0.0F, 1.0F);
        commands.emplace_back(
            SetMedia{with_medium(picture.media, {part.name, medium.attenuation, medium.albedo}), picture.medium_light});
    }
    ImGui::PopID();
}

void draw_light(const npr::Picture& picture, Commands& commands) {
    npr::MediumLight light = picture.medium_light;
    bool changed = false;
    ImGui::SetNextItemWidth(-1);
    changed |=
        ImGui::SliderFloat("##ambient", &light.ambient, 0, 2, "ambient light %.2f", ImGuiSliderFlags_AlwaysClamp);
    ImGui::SetNextItemWidth(-1);
    changed |= ImGui::SliderFloat("##directional", &light.directional, 0, 2, "directional light %.2f",
                                  ImGuiSliderFlags_AlwaysClamp);
    if (changed) {
        commands.emplace_back(SetMedia{picture.media, light});
    }
}

template <typename T>
T parameter(const npr::Picture& picture, std::string_view name) {
    return std::get<T>(picture.parameters.at(*picture.parameters.find(name)));
}

}  // namespace

void draw_media(const Session& session, Commands& commands) {
    const npr::Picture& picture = session.view().picture;
    const auto& model = session.document().model();
    if (picture.transparency != npr::Transparency::Volume || !model) {
        return;
    }
    ImGui::PushID("media");
    const double diagonal = std::max(glm::length(model->geometry.box.hi - model->geometry.box.lo), 1e-9);
    std::size_t drawn = 0;
    for (const csg::Part& part : model->scene.parts) {
        const bool solid = part.kind == csg::PartKind::Solid || part.kind == csg::PartKind::Translucent;
        if (solid && drawn++ < kMostParts) {
            draw_part(picture, part, diagonal, commands);
        }
    }
    draw_light(picture, commands);
    ImGui::PopID();
}

void draw_thickness_legend(const Rectangle& place, const Session& session, const Fonts& fonts, float scale) {
    const npr::Picture& picture = session.view().picture;
    const auto& model = session.document().model();
    if (!is_radiograph(picture) || !model || !parameter<bool>(picture, "legend")) {
        return;
    }
    const int colors = parameter<int>(picture, "colors");
    const float range = parameter<float>(picture, "range");
    const double full = range > 0 ? range : 0.5 * glm::length(model->geometry.box.hi - model->geometry.box.lo);
    if (!(full > 0)) {
        return;
    }
    draw_tone_legend(
        place, full, [colors](float share) { return npr::radiograph_tone(colors, share); },
        npr::radiograph_tone(colors, 0), fonts, scale);
}

}  // namespace ui
