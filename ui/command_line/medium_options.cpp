#include "ui/command_line/medium_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "npr/parameter.h"
#include "npr/part_style.h"
#include "ui/command_line/option_values.h"
#include "ui/pipeline/part_names.h"

namespace ui {

namespace {

glm::vec3 read_color(const std::string& option, std::string_view text) {
    const npr::Parameter color = npr::Parameter::color("albedo", "", glm::vec3(0));
    npr::Parameters parameters(std::span(&color, 1));
    try {
        parameters.read("albedo", text);
    } catch (const std::invalid_argument& error) {
        throw UsageError(fmt::format("{}: {}", option, error.what()));
    }
    return std::get<glm::vec3>(parameters.at(0));
}

}  // namespace

npr::PartMedium read_medium(const std::string& text) {
    const std::string option = fmt::format("--medium {}", text);
    const auto wrong = [&] {
        return UsageError(option + ": expected 'PART: tau=NUMBER/mm, albedo=#rrggbb', or one of the two");
    };
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos) {
        throw wrong();
    }
    npr::PartMedium medium;
    medium.part = trimmed(std::string_view(text).substr(0, colon));
    for (std::string_view rest = std::string_view(text).substr(colon + 1); !rest.empty();) {
        const std::size_t comma = rest.find(',');
        const std::string_view setting = trimmed(rest.substr(0, comma));
        rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
        const std::size_t equals = setting.find('=');
        const std::string_view name = trimmed(setting.substr(0, equals));
        std::string_view value = equals == std::string_view::npos ? "" : trimmed(setting.substr(equals + 1));
        if (name == "tau" && value.ends_with("/mm")) {
            value.remove_suffix(3);
            const double attenuation = read_numbers("--medium tau", trimmed(value), {1}, "a number per mm")[0];
            if (attenuation < 0) {
                throw UsageError(option + ": tau is 0 or more");
            }
            medium.attenuation = static_cast<float>(attenuation);
        } else if (name == "albedo") {
            medium.albedo = read_color(option, value);
        } else {
            throw wrong();
        }
    }
    if (medium.part.empty() || !(medium.attenuation || medium.albedo)) {
        throw wrong();
    }
    return medium;
}

npr::MediumLight read_medium_light(const std::string& text) {
    const auto n = read_numbers("--medium-light", text, {2}, "ambient,directional");
    if (n[0] < 0 || n[1] < 0) {
        throw UsageError(fmt::format("--medium-light {}: light is 0 or more", text));
    }
    return {static_cast<float>(n[0]), static_cast<float>(n[1])};
}

void need_parts(std::span<const npr::PartMedium> media, const csg::Scene& scene) {
    for (const npr::PartMedium& medium : media) {
        if (std::none_of(scene.parts.begin(), scene.parts.end(),
                         [&](const csg::Part& part) { return npr::names_part(medium.part, part.name); })) {
            throw UsageError(unknown_part(scene, "--medium", medium.part));
        }
    }
}

}  // namespace ui
