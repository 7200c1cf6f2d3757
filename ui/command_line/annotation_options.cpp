#include "ui/command_line/annotation_options.h"

#include <fmt/format.h>

#include "csg/scad/builtin/color_names.h"
#include "ui/command_line/option_values.h"
#include "ui/command_line/part_style_options.h"

namespace ui {

namespace {

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// "\n" in a text begins a line.
std::string with_lines(std::string text) {
    for (std::size_t at = 0; (at = text.find("\\n", at)) != std::string::npos; ++at) {
        text.replace(at, 2, "\n");
    }
    return text;
}

/// What is between the brackets behind the points.
void read_settings(const std::string& option, const std::string& text, ArrowRequest& arrow) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string setting = trimmed(text.substr(begin, end - begin));
        const std::size_t equals = setting.find('=');
        const std::string name = trimmed(setting.substr(0, equals));
        const std::string value = equals == std::string::npos ? "" : trimmed(setting.substr(equals + 1));
        if (name == "width" && !value.empty()) {
            arrow.width = read_numbers(option + " width", value, {1}, "a length")[0];
            if (!(*arrow.width > 0)) {
                throw UsageError(fmt::format("{}: the width is above 0", option));
            }
        } else if (name == "color" && csg::scad::find_color(value)) {
            const auto color = *csg::scad::find_color(value);
            arrow.color = csg::Rgba{color.r, color.g, color.b, 1};
        } else {
            throw UsageError(
                fmt::format("{}: \"{}\": expected width=LENGTH or color=COLOR, #rrggbb or a name", option, setting));
        }
        begin = end + 1;
    }
}

ArrowRequest read_arrow(const std::string& text) {
    const std::string option = fmt::format("--arrow {}", text);
    ArrowRequest arrow;
    const std::size_t bracket = text.find('(');
    if (bracket != std::string::npos) {
        const std::size_t close = text.rfind(')');
        if (close == std::string::npos || close < bracket || !trimmed(text.substr(close + 1)).empty()) {
            throw UsageError(fmt::format("{}: expected ')' at the end", option));
        }
        read_settings(option, text.substr(bracket + 1, close - bracket - 1), arrow);
    }
    const std::string points = trimmed(text.substr(0, bracket));
    for (std::size_t begin = 0; begin <= points.size();) {
        const std::size_t end = std::min(points.find(':', begin), points.size());
        const auto n = read_numbers(option, points.substr(begin, end - begin), {3}, "x,y,z:x,y,z");
        arrow.points.emplace_back(n[0], n[1], n[2]);
        if (arrow.points.size() > 1 && arrow.points.back() == arrow.points[arrow.points.size() - 2]) {
            throw UsageError(fmt::format("{}: a point follows itself", option));
        }
        begin = end + 1;
    }
    if (arrow.points.size() < 2) {
        throw UsageError(fmt::format("{}: expected two points or more, x,y,z:x,y,z", option));
    }
    return arrow;
}

}  // namespace

Annotations annotations_of(const AnnotationTexts& texts) {
    Annotations annotations;
    annotations.callouts = texts.callouts;
    for (const std::string& text : texts.labels) {
        const auto [part, label] = split_label(text);
        annotations.labels.push_back({read_part_selector(fmt::format("--label {}", text), part), with_lines(label)});
    }
    for (const std::string& text : texts.arrows) {
        annotations.arrows.push_back(read_arrow(text));
    }
    return annotations;
}

}  // namespace ui
