#include "ui/pipeline/part_selector.h"

#include <stdexcept>

#include <fmt/format.h>

#include "csg/scad/builtin/color_names.h"
#include "ui/pipeline/trimmed.h"

namespace ui {

namespace {

constexpr std::string_view kPart = "part=", kColor = "color=", kModule = "module=";

}  // namespace

npr::PartSelector read_selector(const std::string& text, std::string_view what) {
    npr::PartSelector selector;
    selector.text = what;
    if (what.starts_with(kColor)) {
        const std::string_view name = trimmed(what.substr(kColor.size()));
        const auto color = csg::scad::find_color(name);
        if (!color) {
            throw std::runtime_error(
                fmt::format("{}: no color \"{}\"; expected #rrggbb or a name of color()", text, name));
        }
        selector.by_color = true;
        selector.color = {color->r, color->g, color->b};
        return selector;
    }
    const bool part = what.starts_with(kPart);
    if (!part && !what.starts_with(kModule)) {
        throw std::runtime_error(fmt::format("{}: parts are given as part=NAME, color=COLOR or module=NAME", text));
    }
    selector.name = trimmed(what.substr(part ? kPart.size() : kModule.size()));
    if (selector.name.empty()) {
        throw std::runtime_error(fmt::format("{}: which part?", text));
    }
    return selector;
}

npr::PartSelector read_part_selector(const std::string& text, std::string_view given) {
    std::string what(trimmed(given));
    if (!what.starts_with(kPart) && !what.starts_with(kColor) && !what.starts_with(kModule)) {
        what.insert(0, kPart);
    }
    return read_selector(text, what);
}

}  // namespace ui
