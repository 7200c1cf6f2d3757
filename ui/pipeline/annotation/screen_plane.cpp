#include "ui/pipeline/annotation/screen_plane.h"

namespace ui {

ScreenPlane::ScreenPlane(const base::View& view, double distance) : distance_(distance) {
    // A sample is in the middle of its pixel.
    const auto point = [&](double x, double y) {
        const base::View::Ray ray = view.ray(x - 0.5, y - 0.5);
        return ray.origin + distance * ray.direction;
    };
    origin_ = point(0, 0);
    const glm::dvec2 size(view.size());
    x_ = (point(size.x, 0) - origin_) / size.x;
    y_ = (point(0, size.y) - origin_) / size.y;
    pixel_ = glm::length(y_);
}

glm::dmat4 ScreenPlane::to_world(const glm::dvec2& origin) const {
    return {glm::dvec4(x_, 0), glm::dvec4(y_, 0), glm::dvec4(glm::cross(x_, y_) / pixel_, 0),
            glm::dvec4(at(origin), 1)};
}

SeenAt seen_at(const base::View& view, const glm::dvec3& point) {
    const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(point, 1);
    const double distance = -(view.eye_from_world() * glm::dvec4(point, 1)).z;
    return {0.5 * (glm::dvec2(clip) / clip.w + 1.0) * glm::dvec2(view.size()), distance};
}

}  // namespace ui
