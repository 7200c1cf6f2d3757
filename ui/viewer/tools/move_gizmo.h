// Handles that something is moved by: along an axis, in a plane of two, or in that of the picture.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "base/camera.h"
#include "ui/viewer/layout.h"

namespace ui {

/// Along one axis, along two, and freely.
enum class MoveHandle { X, Y, Z, YZ, ZX, XY, Free };
inline constexpr std::array kMoveHandles{MoveHandle::Free, MoveHandle::YZ, MoveHandle::ZX, MoveHandle::XY,
                                         MoveHandle::X,    MoveHandle::Y,  MoveHandle::Z};
/// By axis: does the handle move along it?
[[nodiscard]] std::array<bool, 3> axes_of(MoveHandle handle);

/// As it is seen by the camera of the picture, of the same size on the screen from everywhere.
class MoveGizmo {
  public:
    /// `center`: world coordinates; `scale`: of the interface.
    MoveGizmo(const base::Camera& camera, const Rectangle& picture, const glm::dvec3& center, float scale);

    /// Nothing where it lies behind the eye.
    [[nodiscard]] std::optional<glm::dvec2> middle() const { return place(glm::dvec3(0)); }
    /// Where an arrow ends; nothing where it points to the eye.
    [[nodiscard]] std::optional<glm::dvec2> tip(MoveHandle axis) const;
    /// The corners of the square that stands for a plane; nothing where that is seen from its edge.
    [[nodiscard]] std::optional<std::array<glm::dvec2, 4>> square(MoveHandle plane) const;
    [[nodiscard]] std::optional<MoveHandle> handle_at(const glm::dvec2& at) const;

    /// What of the line or plane that goes through the center the line of sight meets, or comes nearest to, counted
    /// from the center; nothing where both are all but parallel.
    [[nodiscard]] std::optional<glm::dvec3> grip(MoveHandle handle, const glm::dvec2& at) const;
    /// World units of one unit of the window.
    [[nodiscard]] double unit() const { return unit_; }

  private:
    [[nodiscard]] std::optional<glm::dvec2> place(const glm::dvec3& from_center) const;

    const base::Camera& camera_;
    Rectangle picture_;
    glm::dvec3 center_;
    double unit_, arm_, reach_;
};

/// The way rounded to whole steps along each axis that the handle moves along.
[[nodiscard]] glm::dvec3 in_steps(const glm::dvec3& by, MoveHandle handle, double step);

/// What is typed while something is moved: as many numbers as the handle has axes, with commas between. Those that are
/// not there yet are `by`'s.
[[nodiscard]] glm::dvec3 typed_way(const std::string& typed, MoveHandle handle, const glm::dvec3& by);

}  // namespace ui
