// What the mouse and the keys do to a camera. Pure functions; pixels are counted from the upper left corner, y down.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "base/camera.h"

namespace ui {

/// Turntable about the world's z axis, 0.7 degrees per pixel as in OpenSCAD. A camera that has +z up keeps it up.
void orbit(base::Camera& camera, glm::dvec2 drag);

/// The same about a point (world coordinates), which keeps its place in the picture.
void orbit_about(base::Camera& camera, glm::dvec2 drag, const glm::dvec3& pivot);

/// Shifts the camera so that the plane through its target, parallel to the picture, follows the cursor.
void pan(base::Camera& camera, glm::dvec2 drag, int picture_height);

/// Scales the camera about `fixed` (world coordinates), which keeps its place in the picture in both projections.
/// `factor` below 1 comes nearer. The distance stays within limits that double precision serves well.
void zoom(base::Camera& camera, double factor, const glm::dvec3& fixed);

/// Where the line of sight through the cursor meets the plane through the target, parallel to the picture.
[[nodiscard]] glm::dvec3 point_on_target_plane(const base::Camera& camera, glm::ivec2 size, glm::dvec2 cursor);

/// base::Camera::rotation of a camera that looks from `side` (world coordinates, of any length), +z up. From straight
/// above and below, that which is nearest to `now` of those in which an axis points up.
[[nodiscard]] glm::dvec3 rotation_from(const glm::dvec3& side, const glm::dvec3& now);

/// The other projection; things at the target keep their size, since both use the distance and the field of view.
void toggle_projection(base::Camera& camera);

/// The option of the command line that gives this camera, with --projection where it is orthographic.
[[nodiscard]] std::string camera_option(const base::Camera& camera);

}  // namespace ui
