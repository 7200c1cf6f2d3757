#pragma once

#include <string>
#include <string_view>

#include "base/image.h"

namespace base {

/// read_png of a file's bytes; `name` stands in messages.
[[nodiscard]] Image decode_png(std::string_view bytes, const std::string& name);

}  // namespace base
