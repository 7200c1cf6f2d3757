// Models with parts of them cut away (npr/section.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/camera.h"
#include "npr/section.h"
#include "ui/pipeline/model.h"

namespace ui {

/// Cuts the parts of a scene that is not yet placed by the parts that sections name, and hides these. Throws ModelError
/// with the nearest names where there is no such part, here or among those that stay whole.
void cut_by_parts(csg::Scene& scene, const npr::Sections& sections);

/// Gives each part that was cut so a hatching other than those of the parts next to it, once they are placed.
void set_hatchings(Model& model, const npr::Sections& sections);

struct CutModel {
    std::shared_ptr<const Model> model;
    std::vector<std::string> warnings;  ///< Sections that miss the model, or leave nothing of it.
};

/// All the other sections: each part but those that stay whole, less a half-space or a box, whose faces have the part's
/// color and a hatching other than that of the parts next to it. `camera`: whose eye the sides are told by.
[[nodiscard]] CutModel cut_away(const std::shared_ptr<const Model>& model, const npr::Sections& sections,
                                const base::Camera& camera, const goldfeather::Budget& budget = {});

}  // namespace ui
