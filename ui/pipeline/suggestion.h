// What somebody may have meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ui {

/// ` Did you mean "x" or "y"?` with the candidates that begin with `name`, else with those nearest to it (at most
/// three); `fallback` where none is near.
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> candidates,
                                     std::string_view fallback = "");

}  // namespace ui
