// Labels and arrows as people write them: on the command line and in the window.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "csg/tree/part_rule.h"
#include "ui/pipeline/annotation/annotation.h"

namespace ui {

struct AnnotationTexts {
    std::vector<std::string> labels;  ///< PART=TEXT
    std::vector<std::string> arrows;  ///< x,y,z:x,y,z[:…] (width=LENGTH, color=COLOR)
    bool callouts = false;
    [[nodiscard]] bool any() const { return callouts || !labels.empty() || !arrows.empty(); }
    bool operator==(const AnnotationTexts&) const = default;
};

/// PART and TEXT of PART=TEXT, where PART may be part=NAME, color=COLOR or module=NAME.
[[nodiscard]] std::pair<std::string, std::string> split_label(const std::string& text);
/// "\n" in the text begins a line.
[[nodiscard]] LabelRequest read_label(const std::string& text);
[[nodiscard]] ArrowRequest read_arrow(const std::string& text);
// Each throws std::runtime_error, which begins with the option, where a text is none.

[[nodiscard]] Annotations annotations_of(const AnnotationTexts& texts);

/// Labels and callouts need parts that can be told apart: what is to be one where nothing else says it. Labels that are
/// none do not count.
[[nodiscard]] csg::PartRule parts_of_labels(const AnnotationTexts& texts);

}  // namespace ui
