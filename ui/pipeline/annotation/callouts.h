// What is numbered of a model.
#pragma once

#include <string>
#include <vector>

#include "csg/tree/scene.h"

namespace ui {

struct Callout {
    std::string text;                ///< For the legend: "bolt ×3".
    std::vector<csg::PartId> parts;  ///< bolt, bolt 2, bolt 3.
};

/// Of solid and translucent parts, those that are named alike but for a number together, in their order.
[[nodiscard]] std::vector<Callout> callouts_of(const csg::Scene& scene);

}  // namespace ui
