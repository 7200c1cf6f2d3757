#include "ui/command_line/picture_options.h"

#include <fmt/format.h>

#include <stdexcept>

#include "base/alternatives.h"
#include "npr/style.h"
#include "ui/command_line/part_style_options.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

template <typename Named>
[[noreturn]] void throw_unknown(std::string_view what, std::string_view name, std::span<const Named> known) {
    std::vector<std::string> names;
    for (const Named& each : known) {
        names.emplace_back(each.name);
    }
    throw std::runtime_error(fmt::format(
        "no {} \"{}\".{}", what, name, suggestion(name, names, fmt::format(" There are {}.", fmt::join(names, ", ")))));
}

}  // namespace

npr::Picture picture_of(npr::Picture picture, const PictureTexts& texts) {
    const npr::StyleInfo* style = npr::find_style(texts.style);
    if (style == nullptr) {
        throw_unknown("style", texts.style, npr::styles());
    }
    const npr::ColorScheme* scheme = npr::find_color_scheme(texts.scheme);
    if (scheme == nullptr) {
        throw_unknown("color scheme", texts.scheme, npr::color_schemes());
    }
    picture.scheme = *scheme;
    picture.draw_as(*style);
    for (const auto& [name, value] : texts.settings) {
        try {
            picture.parameters.read(name, value);
        } catch (const std::invalid_argument& error) {
            throw std::runtime_error(fmt::format("style {}: {}", texts.style, error.what()));
        }
    }
    for (const std::string& text : texts.reveal) {
        picture.reveal.push_back(read_revealed_part(text));
    }
    for (const std::string& text : texts.part_styles) {
        picture.part_styles.push_back(read_part_style(text));
    }
    return picture;
}

std::string style_names() {
    std::vector<std::string> names;
    for (const npr::StyleInfo& style : npr::styles()) {
        names.emplace_back(style.name);
    }
    return fmt::format("{} ({})", base::alternatives(names), names.front());
}

}  // namespace ui
