#include "ui/command_line/part_style_rule.h"

#include <algorithm>
#include <string_view>

namespace ui {

namespace {

constexpr std::string_view kOfColor = "color=", kOfModule = "module=";

/// What stands before the colon, or the comma, without blanks.
std::string_view selector(std::string_view text) {
    text = text.substr(0, std::min(text.rfind(':'), text.find(',')));
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

csg::PartRule parts_of_styles(std::span<const std::string> texts) {
    csg::PartRule rule;
    rule.kind = csg::PartRule::Kind::Depth;
    for (const std::string& text : texts) {
        const std::string_view what = selector(text);
        if (what.starts_with(kOfModule)) {
            rule.kind = csg::PartRule::Kind::Module;
            rule.modules.emplace_back(what.substr(kOfModule.size()));
        } else if (what.starts_with(kOfColor) && rule.kind == csg::PartRule::Kind::Depth) {
            rule.kind = csg::PartRule::Kind::Color;
        }
    }
    return rule;
}

}  // namespace ui
