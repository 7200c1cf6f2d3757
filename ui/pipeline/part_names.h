// Parts by the names that people give.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "csg/tree/scene.h"
#include "npr/part_style.h"

namespace ui {

/// "bolt" names the parts bolt, bolt 2, bolt 3, …; "bolt 2" that one. Throws ModelError, which tells the nearest names,
/// where there is none. `option`: who asks.
[[nodiscard]] std::vector<csg::PartId> parts_named(const csg::Scene& scene, const char* option,
                                                   const std::string& name);

/// Those that a selector means. Throws ModelError as above.
[[nodiscard]] std::vector<csg::PartId> parts_selected(const csg::Scene& scene, std::string_view option,
                                                      const npr::PartSelector& selector);

/// What is to be said where `option` names a part that the scene does not have: the nearest names, or those there are.
[[nodiscard]] std::string unknown_part(const csg::Scene& scene, std::string_view option, std::string_view name);

}  // namespace ui
