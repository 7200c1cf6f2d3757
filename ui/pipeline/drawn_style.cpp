#include "ui/pipeline/drawn_style.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "npr/style.h"
#include "ui/pipeline/suggestion.h"
#include "ui/pipeline/trimmed.h"

namespace ui {

namespace {

const npr::StyleInfo& style_called(std::string_view name) {
    if (const npr::StyleInfo* style = npr::find_style(name)) {
        return *style;
    }
    std::vector<std::string> names;
    for (const npr::StyleInfo& each : npr::styles()) {
        names.emplace_back(each.name);
    }
    const std::string all = fmt::format(" There are {}.", fmt::join(names, ", "));
    throw std::runtime_error(fmt::format("no style \"{}\".{}", name, suggestion(name, names, all)));
}

}  // namespace

npr::PartStyle read_drawn_style(std::string_view drawn) {
    npr::PartStyle result;
    std::size_t comma = drawn.find(',');
    result.style = &style_called(trimmed(drawn.substr(0, comma)));
    result.parameters = npr::Parameters(result.style->parameters);
    while (comma != std::string_view::npos) {
        const std::size_t next = drawn.find(',', comma + 1);
        const std::string_view setting =
            trimmed(drawn.substr(comma + 1, next == std::string_view::npos ? next : next - comma - 1));
        const std::size_t equals = setting.find('=');
        if (equals == 0 || equals == std::string_view::npos) {
            throw std::runtime_error(fmt::format("\"{}\": expected PARAMETER=VALUE", setting));
        }
        try {
            result.parameters.read(trimmed(setting.substr(0, equals)), trimmed(setting.substr(equals + 1)));
        } catch (const std::invalid_argument& error) {
            throw std::runtime_error(fmt::format("style {}: {}", result.style->name, error.what()));
        }
        comma = next;
    }
    return result;
}

}  // namespace ui
