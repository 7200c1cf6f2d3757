#include "ui/command_line/part_style_options.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "ui/command_line/option_values.h"
#include "ui/pipeline/drawn_style.h"
#include "ui/pipeline/part_names.h"
#include "ui/pipeline/part_selector.h"

namespace ui {

namespace {

constexpr std::string_view kColor = "color=";

/// `text`: of the option, with its name.
std::runtime_error wrong(const std::string& text, std::string_view why) {
    return std::runtime_error(fmt::format("{}: {}", text, why));
}

/// The text before the colon, and what comes after it.
std::pair<std::string_view, std::string_view> split(const std::string& text, const std::string& given) {
    const std::size_t colon = given.rfind(':');
    if (colon == std::string::npos) {
        throw wrong(text, "expected 'part=NAME: STYLE,PARAMETER=VALUE,…', or color=COLOR or module=NAME for part=NAME");
    }
    return {trimmed(std::string_view(given).substr(0, colon)), trimmed(std::string_view(given).substr(colon + 1))};
}

void need_part(const csg::Scene& scene, std::string_view option, const npr::PartSelector& selector) {
    const bool known = std::any_of(scene.parts.begin(), scene.parts.end(), [&](const csg::Part& part) {
        layers::PartLook look;
        look.name = part.name;
        look.color = {part.color.r, part.color.g, part.color.b, part.color.a};
        return npr::selects(selector, look);
    });
    if (!known) {
        const std::string name = selector.by_color ? selector.text.substr(kColor.size()) : selector.name;
        throw UsageError(unknown_part(scene, fmt::format("{} {}", option, selector.text), name));
    }
}

}  // namespace

npr::PartStyle read_part_style(const std::string& given) {
    const std::string text = fmt::format("--style-of {}", given);
    const auto [what, drawn] = split(text, given);
    try {
        const npr::PartSelector of = read_selector(text, what);
        npr::PartStyle result = read_drawn_style(drawn);
        result.of = of;
        return result;
    } catch (const std::runtime_error& error) {
        // Selectors name the option by themselves.
        const std::string why = error.what();
        throw std::runtime_error(why.starts_with(text) ? why : fmt::format("{}: {}", text, why));
    }
}

npr::RevealedPart read_revealed_part(const std::string& text) {
    const std::string option = fmt::format("--reveal {}", text);
    const std::size_t comma = text.rfind(',');
    npr::RevealedPart result;
    result.of = read_part_selector(option, std::string_view(text).substr(0, comma));
    if (comma != std::string::npos) {
        result.fraction = read_numbers(option, trimmed(std::string_view(text).substr(comma + 1)), {1}, "a share")[0];
        if (!(result.fraction > 0 && result.fraction <= 1)) {
            throw wrong(option, "a share is above 0 and at most 1");
        }
    }
    return result;
}

void need_parts(std::span<const npr::PartStyle> styles, const csg::Scene& scene) {
    for (const npr::PartStyle& style : styles) {
        need_part(scene, "--style-of", style.of);
    }
}

void need_parts(std::span<const npr::RevealedPart> revealed, const csg::Scene& scene) {
    for (const npr::RevealedPart& each : revealed) {
        need_part(scene, "--reveal", each.of);
    }
}

}  // namespace ui
