// Turns of the camera that are seen to happen: from where it looks to a standard view, within a moment.
#pragma once

#include <optional>

#include "base/camera.h"

namespace ui {

/// Times are seconds of any steady clock.
class CameraFlight {
  public:
    /// The camera turns from `rotation` (base::Camera::rotation) to its own; it stands at the first step then.
    void start(base::Camera& camera, const glm::dvec3& rotation, double now);
    /// Where it is by now; at the end exactly where it was to go.
    void advance(base::Camera& camera, double now);
    /// It stays where it is.
    void stop() { way_.reset(); }
    /// It is at its end at once.
    void finish(base::Camera& camera);
    [[nodiscard]] bool under_way() const { return way_.has_value(); }

  private:
    struct Way {
        glm::dvec3 from, to;
        double began;
    };
    std::optional<Way> way_;
};

}  // namespace ui
