// When and where bodies begin to touch.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <stop_token>
#include <string>
#include <vector>

#include "ui/pipeline/motion/motion.h"

namespace ui {

struct Contact {
    double time = 0;        ///< Of $t: they were apart just before.
    glm::dvec3 point{0.0};  ///< World units: half way between their nearest points then.
    std::string with;       ///< The other body's name; empty: something that stands still.
};

/// Those of one body with others that `meant` names, and with what stands still where it names "" too, by time. Bodies
/// are rigid, by their exact meshes, and led from sample to sample by their screws: a time is off by at most the
/// motion's error over the speed at which they approach each other. Which contacts are found: see Approach.
[[nodiscard]] std::vector<Contact> contacts_of(const Motion& motion, const MovingBody& body,
                                               const std::function<bool(const std::string& name)>& meant, double from,
                                               double to, const std::stop_token& stop = {});

}  // namespace ui
