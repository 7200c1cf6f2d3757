// What the command line says of glyphs in pictures, read.
#pragma once

#include "ui/command_line/annotation_texts.h"
#include "ui/pipeline/annotation/annotation.h"

namespace ui {

/// Throws std::runtime_error where a text is none; names the nearest color.
[[nodiscard]] Annotations annotations_of(const AnnotationTexts& texts);

}  // namespace ui
