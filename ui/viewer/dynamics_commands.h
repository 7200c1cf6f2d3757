// What the panel of motion and labels asks for.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "ui/pipeline/annotation/annotation_texts.h"

namespace ui {

/// What is drawn of the motion, and written into the picture, as the command line takes it.
struct GlyphTexts {
    std::vector<std::string> depictions;  ///< --depict
    std::string rules_file;               ///< --depict-rules; empty: none.
    AnnotationTexts annotations;
    [[nodiscard]] bool any() const { return !depictions.empty() || !rules_file.empty() || annotations.any(); }
    bool operator==(const GlyphTexts&) const = default;
};

struct SetGlyphs {
    GlyphTexts texts;
};
/// A technique for the body that is selected.
struct DepictSelected {
    std::string technique;
};
/// A label at the part that is selected.
struct LabelSelected {
    std::string text;
};
/// The search for what moves is given up, until it is asked for again.
struct CancelMotion {};
struct LookForMotion {};

using DynamicsCommand = std::variant<SetGlyphs, DepictSelected, LabelSelected, CancelMotion, LookForMotion>;

}  // namespace ui
