#include "ui/viewer/camera_control.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

namespace ui {
namespace {

constexpr double kDegreesPerPixel = 0.7;
constexpr double kNearest = 1e-6, kFarthest = 1e9;

double wrapped(double degrees) {
    const double turned = std::fmod(degrees, 360.0);
    return turned < 0 ? turned + 360.0 : turned;
}

double half_fov_tangent(const base::Camera& camera) {
    return std::tan(camera.fov / 360.0 * glm::pi<double>());
}

/// Axes of the picture in world coordinates: right, up, towards the eye.
std::array<glm::dvec3, 3> axes(const base::Camera& camera) {
    const glm::dmat3 world_from_eye = glm::transpose(glm::dmat3(camera.eye_from_world()));
    return {world_from_eye[0], world_from_eye[1], world_from_eye[2]};
}

/// World units per pixel in the plane through the target.
double pixel_size(const base::Camera& camera, int picture_height) {
    return 2 * camera.distance * half_fov_tangent(camera) / std::max(picture_height, 1);
}

}  // namespace

void orbit(base::Camera& camera, glm::dvec2 drag) {
    const double tilt = camera.rotation.x;
    const double turned = tilt - kDegreesPerPixel * drag.y;
    const bool upright = tilt >= 0 && tilt <= 180;  // Cameras of files may hang upside down: those turn freely.
    camera.rotation.x = upright ? std::clamp(turned, 0.0, 180.0) : wrapped(turned);
    camera.rotation.z = wrapped(camera.rotation.z - kDegreesPerPixel * drag.x);
}

void orbit_about(base::Camera& camera, glm::dvec2 drag, const glm::dvec3& pivot) {
    const glm::dvec3 from_target = glm::dmat3(camera.eye_from_world()) * (pivot - camera.target);
    orbit(camera, drag);
    camera.target = pivot - glm::transpose(glm::dmat3(camera.eye_from_world())) * from_target;
}

void pan(base::Camera& camera, glm::dvec2 drag, int picture_height) {
    const auto [right, up, back] = axes(camera);
    camera.target += pixel_size(camera, picture_height) * (up * drag.y - right * drag.x);
}

void zoom(base::Camera& camera, double factor, const glm::dvec3& fixed) {
    const double distance = std::clamp(camera.distance * factor, kNearest, kFarthest);
    camera.target = fixed + distance / camera.distance * (camera.target - fixed);
    camera.distance = distance;
}

glm::dvec3 point_on_target_plane(const base::Camera& camera, glm::ivec2 size, glm::dvec2 cursor) {
    const auto [right, up, back] = axes(camera);
    const glm::dvec2 from_middle = cursor - 0.5 * glm::dvec2(size);
    return camera.target + pixel_size(camera, size.y) * (right * from_middle.x - up * from_middle.y);
}

glm::dvec3 rotation_from(const glm::dvec3& side, const glm::dvec3& now) {
    const glm::dvec3 to_eye = glm::normalize(side);
    const double tilt = glm::degrees(std::acos(std::clamp(to_eye.z, -1.0, 1.0)));
    const bool upright = to_eye.x != 0 || to_eye.y != 0;
    const double turn = upright ? glm::degrees(std::atan2(to_eye.x, -to_eye.y)) : 90 * std::round(now.z / 90);
    return {tilt, 0, wrapped(turn)};
}

void toggle_projection(base::Camera& camera) {
    camera.projection = camera.projection == base::Projection::Perspective ? base::Projection::Orthographic
                                                                           : base::Projection::Perspective;
}

std::string camera_option(const base::Camera& camera) {
    const glm::dvec3 &t = camera.target, &r = camera.rotation;
    return fmt::format("--camera {:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}{}", t.x, t.y, t.z, r.x, r.y, r.z,
                       camera.distance, camera.projection == base::Projection::Orthographic ? " --projection o" : "");
}

}  // namespace ui
