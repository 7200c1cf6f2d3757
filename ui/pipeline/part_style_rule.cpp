#include "ui/pipeline/part_style_rule.h"

#include <algorithm>
#include <string_view>

#include "ui/pipeline/trimmed.h"

namespace ui {

namespace {

constexpr std::string_view kOfColor = "color=", kOfModule = "module=";

/// What stands before the colon, or the comma, without blanks.
std::string_view selector(std::string_view text) {
    return trimmed(text.substr(0, std::min(text.rfind(':'), text.find(','))));
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
