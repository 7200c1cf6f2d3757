#include "ui/viewer/picture_places.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace ui {

std::optional<glm::dvec2> place_of(const base::Camera& camera, const Rectangle& picture, const glm::dvec3& point) {
    const base::View view(camera, glm::max(glm::ivec2(picture.size), 1), point, point);
    const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(point, 1);
    if (clip.w <= 0) {
        return std::nullopt;
    }
    const glm::dvec2 from_corner(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w);
    return glm::dvec2(picture.corner) + from_corner * glm::dvec2(picture.size);
}

base::View::Ray sight(const base::Camera& camera, const Rectangle& picture, const glm::dvec2& at) {
    const base::View view(camera, glm::max(glm::ivec2(picture.size), 1), camera.target, camera.target);
    const glm::dvec2 from_corner = at - glm::dvec2(picture.corner);
    return view.ray(from_corner.x - 0.5, static_cast<double>(picture.size.y) - from_corner.y - 0.5);
}

double unit_at(const base::Camera& camera, const Rectangle& picture, const glm::dvec3& point) {
    const glm::dvec4 in_eye = camera.eye_from_world() * glm::dvec4(point, 1);
    const double away =
        camera.projection == base::Projection::Perspective ? std::max(-in_eye.z, 1e-9) : camera.distance;
    return 2 * away * std::tan(camera.fov / 360 * glm::pi<double>()) / std::max(picture.size.y, 1.0F);
}

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 way = b - a;
    const double square = glm::dot(way, way);
    const double t = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0;
    return glm::distance(p, a + t * way);
}

}  // namespace ui
