// What the command line says of glyphs in pictures, as texts.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ui {

struct AnnotationTexts {
    std::vector<std::string> labels, arrows;
    bool callouts = false;
    [[nodiscard]] bool any() const { return callouts || !labels.empty() || !arrows.empty(); }
};

/// PART and TEXT of PART=TEXT, where PART may be part=NAME, color=COLOR or module=NAME. Throws UsageError.
[[nodiscard]] std::pair<std::string, std::string> split_label(const std::string& text);

}  // namespace ui
