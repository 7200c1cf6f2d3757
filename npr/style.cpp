#include "npr/style.h"

#include <algorithm>
#include <array>

#include "npr/blueprint.h"
#include "npr/edges.h"
#include "npr/shaded.h"

namespace npr {
std::span<const StyleInfo> styles() {
    return kStyles;
}

const StyleInfo* find_style(std::string_view name) {
    const auto* found =
        std::find_if(kStyles.begin(), kStyles.end(), [&](const StyleInfo& s) { return s.name == name; });
    return found == kStyles.end() ? nullptr : &*found;
}

}  // namespace npr
