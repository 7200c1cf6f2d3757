// Things that are measured, drawn over the picture.
#pragma once

#include <string>

#include "ui/pipeline/inspection/measured.h"
#include "ui/viewer/tool.h"

namespace ui {

/// How far the thing is seen from a place in the window, in its units: of edges and circles their point that is nearest
/// to `near` (world coordinates). Far away where it lies behind the eye.
[[nodiscard]] double distance_on_screen(const base::Camera& camera, const Rectangle& picture, const Measured& thing,
                                        const glm::dvec3& near, const glm::dvec2& at);

struct MeasuredMarks {
    const ToolPainter& painter;
    const base::Camera& camera;
    const Rectangle& picture;

    /// A corner is a ring, an edge a line; a face is a dot with its normal, or with the circle and the axis about it.
    void thing(const Measured& thing, ImU32 color) const;
    /// The line that the distance is along, with the distance beside it.
    void distance(const Relation& relation) const;
    void box(const csg::Box& box, ImU32 color) const;
    /// Lines of text in the upper left corner.
    void note(const std::string& text) const;

  private:
    void line(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float width) const;
    void ring(const glm::dvec3& center, const glm::dvec3& axis, double radius, ImU32 color) const;
    void dot(const glm::dvec3& at, ImU32 color, bool filled) const;
};

}  // namespace ui
