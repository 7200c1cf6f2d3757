// Which of the bodies that move something in a model is part of.
#pragma once

#include <glm/glm.hpp>

#include "ui/pipeline/model.h"
#include "ui/pipeline/motion/motion.h"

namespace ui {

/// The body that the occurrence's leaf belongs to: its call is among those that made the leaf; of several that one call
/// has made, the one whose box, as it is at that time, is nearest to the point (world units). Null where it stands
/// still.
[[nodiscard]] const MovingBody* body_at(const Motion& motion, const Model& model, csg::OccurrenceId occurrence,
                                        const glm::dvec3& point, double time);

}  // namespace ui
