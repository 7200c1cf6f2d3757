#include "ui/command_line/part_style_options.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "csg/scad/builtin/color_names.h"
#include "npr/style.h"
#include "ui/command_line/option_values.h"
#include "ui/pipeline/part_names.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

constexpr std::string_view kPart = "part=", kColor = "color=", kModule = "module=";

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

npr::PartSelector read_selector(const std::string& text, std::string_view what) {
    npr::PartSelector selector;
    selector.text = what;
    if (what.starts_with(kColor)) {
        const std::string_view name = trimmed(what.substr(kColor.size()));
        const auto color = csg::scad::find_color(name);
        if (!color) {
            throw wrong(text, fmt::format("no color \"{}\"; expected #rrggbb or a name of color()", name));
        }
        selector.by_color = true;
        selector.color = {color->r, color->g, color->b};
        return selector;
    }
    const bool part = what.starts_with(kPart);
    if (!part && !what.starts_with(kModule)) {
        throw wrong(text, "parts are given as part=NAME, color=COLOR or module=NAME");
    }
    selector.name = trimmed(what.substr(part ? kPart.size() : kModule.size()));
    if (selector.name.empty()) {
        throw wrong(text, "which part?");
    }
    return selector;
}

const npr::StyleInfo& read_style(const std::string& text, std::string_view name) {
    if (const npr::StyleInfo* style = npr::find_style(name)) {
        return *style;
    }
    std::vector<std::string> names;
    for (const npr::StyleInfo& each : npr::styles()) {
        names.emplace_back(each.name);
    }
    const std::string all = fmt::format(" There are {}.", fmt::join(names, ", "));
    throw wrong(text, fmt::format("no style \"{}\".{}", name, suggestion(name, names, all)));
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
    npr::PartStyle result;
    result.of = read_selector(text, what);
    std::size_t comma = drawn.find(',');
    result.style = &read_style(text, trimmed(drawn.substr(0, comma)));
    result.parameters = npr::Parameters(result.style->parameters);
    while (comma != std::string_view::npos) {
        const std::size_t next = drawn.find(',', comma + 1);
        const std::string_view setting =
            trimmed(drawn.substr(comma + 1, next == std::string_view::npos ? next : next - comma - 1));
        const std::size_t equals = setting.find('=');
        if (equals == 0 || equals == std::string_view::npos) {
            throw wrong(text, fmt::format("\"{}\": expected PARAMETER=VALUE", setting));
        }
        try {
            result.parameters.read(trimmed(setting.substr(0, equals)), trimmed(setting.substr(equals + 1)));
        } catch (const std::invalid_argument& error) {
            throw wrong(text, fmt::format("style {}: {}", result.style->name, error.what()));
        }
        comma = next;
    }
    return result;
}

npr::PartSelector read_part_selector(const std::string& text, std::string_view given) {
    std::string what(trimmed(given));
    if (!what.starts_with(kPart) && !what.starts_with(kColor) && !what.starts_with(kModule)) {
        what.insert(0, kPart);
    }
    return read_selector(text, what);
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
