#include "npr/transparency.h"

#include <algorithm>
#include <array>

#include "npr/picture.h"
#include "npr/screen_door_settings.h"
#include "npr/shine/view_dependent_settings.h"
#include "npr/sorted/sorted_settings.h"
#include "npr/style.h"

namespace npr {

std::span<const TransparencyInfo> transparencies() {
    static const std::array kAll{
        TransparencyInfo{Transparency::Exact, "exact", "Faces"},
        TransparencyInfo{Transparency::Volume, "volume", "Bodies"},
        TransparencyInfo{Transparency::ViewDependent, "view-dependent", "Illustration",
                         ViewDependentSettings::table().parameters()},
        TransparencyInfo{Transparency::ScreenDoor, "screen-door", "Screen doors",
                         ScreenDoorSettings::table().parameters()},
        TransparencyInfo{Transparency::Sorted, "sorted", "Sorted triangles", SortedSettings::table().parameters()},
    };
    return kAll;
}

const TransparencyInfo* find_transparency(std::string_view name) {
    const auto all = transparencies();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
    return found == all.end() ? nullptr : &*found;
}

bool follows_transparency(const StyleInfo& style) {
    static constexpr std::array<std::string_view, 5> kNames{"shaded", "edges", "gooch", "toon", "ntone"};
    return std::find(kNames.begin(), kNames.end(), style.name) != kNames.end();
}

void Picture::see_through_as(const TransparencyInfo& info) {
    transparency = info.model;
    transparency_parameters = Parameters(info.parameters);
}

}  // namespace npr
