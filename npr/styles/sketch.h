// Styles drawn by hand: the same rules with other settings.
#pragma once

#include "npr/style.h"
#include "npr/styles/sketch_settings.h"

namespace npr {

/// A style with the parameters of `table`, which declares all of the fields that shaders read; `set` gives those that
/// have no parameter their values.
[[nodiscard]] StyleInfo drawn_by_hand(std::string_view name, std::string_view label,
                                      const SettingsTable<SketchSettings>& table, void (*set)(SketchSettings&));

}  // namespace npr
