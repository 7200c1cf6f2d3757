#include "npr/style.h"

#include <algorithm>
#include <array>

#include "npr/styles/blueprint.h"
#include "npr/styles/edges.h"
#include "npr/styles/shaded.h"
#include "npr/styles/sketch.h"
#include "npr/styles/xray.h"

namespace npr {

std::span<const StyleInfo> styles() {
    static const std::array all{shaded_style(), edges_style(), blueprint_style(), xray_style(), sketch_style()};
    return all;
}

const StyleInfo* find_style(std::string_view name) {
    const auto all = styles();
    const auto found = std::find_if(all.begin(), all.end(), [&](const StyleInfo& s) { return s.name == name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace npr
