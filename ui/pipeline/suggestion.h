// What somebody may have meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ui {

/// ` Did you mean "x"?` where a candidate is near to `name`, else `fallback`.
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> candidates,
                                     std::string_view fallback = "");

}  // namespace ui
