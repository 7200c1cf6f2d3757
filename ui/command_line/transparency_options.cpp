#include "ui/command_line/transparency_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/command_line/option_values.h"

namespace ui {

void read_transparency(npr::Picture& picture, const std::string& text) {
    if (text.empty()) {
        return;
    }
    using Model = const npr::TransparencyInfo*;
    std::vector<std::pair<std::string, Model>> names;
    for (const npr::TransparencyInfo& each : npr::transparencies()) {
        names.emplace_back(each.name, &each);
    }
    const std::size_t colon = text.find(':');
    const Model model = read_name<Model>("--transparency", text.substr(0, colon), names);
    picture.see_through_as(*model);
    std::string_view rest = colon == std::string::npos ? "" : std::string_view(text).substr(colon + 1);
    if (colon != std::string::npos && rest.empty()) {
        throw UsageError(fmt::format("--transparency {}: expected NAME:KEY=VALUE,...", text));
    }
    while (!rest.empty()) {
        const std::size_t comma = rest.find(',');
        const std::string_view setting = rest.substr(0, comma);
        rest = comma == std::string_view::npos ? "" : rest.substr(comma + 1);
        const std::size_t equals = setting.find('=');
        if (equals == std::string_view::npos) {
            throw UsageError(fmt::format("--transparency {}: \"{}\" is not KEY=VALUE", text, setting));
        }
        if (model->parameters.empty()) {
            throw UsageError(fmt::format("--transparency {}: {} has no parameters", text, model->name));
        }
        try {
            picture.transparency_parameters.read(setting.substr(0, equals), setting.substr(equals + 1));
        } catch (const std::invalid_argument& error) {
            throw UsageError(fmt::format("--transparency {}: {}", model->name, error.what()));
        }
    }
}

void read_blend(npr::Picture& picture, const std::string& text) {
    if (text.empty()) {
        return;
    }
    if (picture.transparency != npr::Transparency::Sorted) {
        throw UsageError("--blend is for --transparency sorted");
    }
    std::vector<std::string> values;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        values.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    if (values.size() != 2 && values.size() != 3 && values.size() != 6) {
        throw UsageError(
            fmt::format("--blend {}: expected SRC,DST, SRC,DST,EQUATION or these for color and alpha", text));
    }
    // One of two or three is of color and alpha alike, as OpenGL has it.
    const std::array<const char*, 3> color{"src", "dst", "equation"}, alpha{"src-alpha", "dst-alpha", "alpha-equation"};
    try {
        for (std::size_t i = 0; i < 3 && i < values.size(); ++i) {
            picture.transparency_parameters.read(color[i], values[i]);
            picture.transparency_parameters.read(alpha[i], values[values.size() == 6 ? i + 3 : i]);
        }
    } catch (const std::invalid_argument& error) {
        throw UsageError(fmt::format("--blend {}: {}", text, error.what()));
    }
}

}  // namespace ui
