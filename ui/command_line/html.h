// Pieces of HTML pages.
#pragma once

#include <string>

#include "base/image.h"

namespace ui {

/// The text as a page shows it.
[[nodiscard]] std::string html(const std::string& text);

/// The same within quotes, as the value of an attribute.
[[nodiscard]] std::string attribute(const std::string& text);

/// An <img> that holds the picture itself.
[[nodiscard]] std::string picture(const base::Image& image, const char* alt);

}  // namespace ui
