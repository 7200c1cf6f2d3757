#include "ui/viewer/camera_flight.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double kSeconds = 0.3, kFirstStep = 1.0 / 60;

/// The shorter way from one angle to the other, in degrees.
double way_between(double from, double to) {
    return std::remainder(to - from, 360);
}

}  // namespace

void CameraFlight::start(base::Camera& camera, const glm::dvec3& rotation, double now) {
    way_ = Way{rotation, camera.rotation, now - kFirstStep};
    advance(camera, now);
}

void CameraFlight::advance(base::Camera& camera, double now) {
    if (!way_) {
        return;
    }
    const double t = std::clamp((now - way_->began) / kSeconds, 0.0, 1.0);
    if (t >= 1) {
        finish(camera);
        return;
    }
    const double eased = t * t * (3 - 2 * t);
    for (int i = 0; i < 3; ++i) {
        camera.rotation[i] = way_->from[i] + eased * way_between(way_->from[i], way_->to[i]);
    }
}

void CameraFlight::finish(base::Camera& camera) {
    if (way_) {
        camera.rotation = way_->to;
        way_.reset();
    }
}

}  // namespace ui
