#include "ui/pipeline/annotation/annotation_texts.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "csg/scad/builtin/color_names.h"
#include "ui/pipeline/part_selector.h"
#include "ui/pipeline/part_style_rule.h"
#include "ui/pipeline/trimmed.h"

namespace ui {

namespace {

std::string with_lines(std::string text) {
    for (std::size_t at = 0; (at = text.find("\\n", at)) != std::string::npos; ++at) {
        text.replace(at, 2, 1, '\n');
    }
    return text;
}

/// Where the = between part and text is; none where one of them is not there.
std::optional<std::size_t> find_split(const std::string& text) {
    std::size_t begin = 0;
    for (const std::string_view word : {"part=", "color=", "module="}) {
        if (text.starts_with(word)) {
            begin = word.size();
        }
    }
    const std::size_t equals = text.find('=', begin);
    const bool good = equals != std::string::npos && equals != begin && equals + 1 != text.size();
    return good ? std::optional(equals) : std::nullopt;
}

/// A number that begins there, behind which `at` is then; none where there is none.
std::optional<double> take_number(const char*& at, const char* end) {
    while (at != end && *at == ' ') {
        ++at;
    }
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) {
        return std::nullopt;
    }
    at = next;
    return value;
}

glm::dvec3 read_point(const std::string& option, const std::string& text) {
    glm::dvec3 point(0.0);
    const char *at = text.data(), *const end = at + text.size();
    for (int i = 0; i < 3; ++i) {
        const auto value = take_number(at, end);
        if (!value || (i < 2 && (at == end || *at++ != ','))) {
            throw std::runtime_error(fmt::format("{}: \"{}\": expected x,y,z:x,y,z", option, text));
        }
        point[i] = *value;
    }
    if (!trimmed({at, static_cast<std::size_t>(end - at)}).empty()) {
        throw std::runtime_error(fmt::format("{}: \"{}\": expected x,y,z:x,y,z", option, text));
    }
    return point;
}

/// What is between the brackets behind the points.
void read_settings(const std::string& option, const std::string& text, ArrowRequest& arrow) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string setting(trimmed(std::string_view(text).substr(begin, end - begin)));
        const std::size_t equals = setting.find('=');
        const std::string name(trimmed(std::string_view(setting).substr(0, equals)));
        const std::string value(equals == std::string::npos ? ""
                                                            : trimmed(std::string_view(setting).substr(equals + 1)));
        if (name == "width" && !value.empty()) {
            const char* at = value.data();
            arrow.width = take_number(at, value.data() + value.size());
            if (!arrow.width || at != value.data() + value.size() || !(*arrow.width > 0)) {
                throw std::runtime_error(fmt::format("{}: width={}: expected a length above 0", option, value));
            }
        } else if (const auto color = csg::scad::find_color(value); name == "color" && color) {
            arrow.color = csg::Rgba{color->r, color->g, color->b, 1};
        } else {
            throw std::runtime_error(
                fmt::format("{}: \"{}\": expected width=LENGTH or color=COLOR, #rrggbb or a name", option, setting));
        }
        begin = end + 1;
    }
}

}  // namespace

std::pair<std::string, std::string> split_label(const std::string& text) {
    const auto split = find_split(text);
    if (!split) {
        throw std::runtime_error(fmt::format("--label {}: expected PART=TEXT", text));
    }
    return {text.substr(0, *split), text.substr(*split + 1)};
}

LabelRequest read_label(const std::string& text) {
    const auto [part, label] = split_label(text);
    return {read_part_selector(fmt::format("--label {}", text), part), with_lines(label)};
}

ArrowRequest read_arrow(const std::string& text) {
    const std::string option = fmt::format("--arrow {}", text);
    ArrowRequest arrow;
    const std::size_t bracket = text.find('(');
    if (bracket != std::string::npos) {
        const std::size_t close = text.rfind(')');
        if (close == std::string::npos || close < bracket ||
            !trimmed(std::string_view(text).substr(close + 1)).empty()) {
            throw std::runtime_error(fmt::format("{}: expected ')' at the end", option));
        }
        read_settings(option, text.substr(bracket + 1, close - bracket - 1), arrow);
    }
    const std::string points(trimmed(std::string_view(text).substr(0, bracket)));
    for (std::size_t begin = 0; begin <= points.size();) {
        const std::size_t end = std::min(points.find(':', begin), points.size());
        arrow.points.push_back(read_point(option, points.substr(begin, end - begin)));
        if (arrow.points.size() > 1 && arrow.points.back() == arrow.points[arrow.points.size() - 2]) {
            throw std::runtime_error(fmt::format("{}: a point follows itself", option));
        }
        begin = end + 1;
    }
    if (arrow.points.size() < 2) {
        throw std::runtime_error(fmt::format("{}: expected two points or more, x,y,z:x,y,z", option));
    }
    return arrow;
}

Annotations annotations_of(const AnnotationTexts& texts) {
    Annotations annotations;
    annotations.callouts = texts.callouts;
    for (const std::string& text : texts.labels) {
        annotations.labels.push_back(read_label(text));
    }
    for (const std::string& text : texts.arrows) {
        annotations.arrows.push_back(read_arrow(text));
    }
    return annotations;
}

csg::PartRule parts_of_labels(const AnnotationTexts& texts) {
    std::vector<std::string> named;
    for (const std::string& label : texts.labels) {
        if (const auto split = find_split(label)) {
            named.push_back(label.substr(0, *split));
        }
    }
    return parts_of_styles(named);
}

}  // namespace ui
