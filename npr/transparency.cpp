#include "npr/transparency.h"

#include <algorithm>
#include <array>

namespace npr {

std::span<const TransparencyInfo> transparencies() {
    static constexpr std::array kAll{
        TransparencyInfo{Transparency::Exact, "exact", "Faces"},
        TransparencyInfo{Transparency::Volume, "volume", "Bodies"},
    };
    return kAll;
}

const TransparencyInfo* find_transparency(std::string_view name) {
    const auto all = transparencies();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace npr
