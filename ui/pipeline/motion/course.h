// Where a body is at any time of a motion, and the ways of its points.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ui/pipeline/motion/motion.h"

namespace ui {

class Course {
  public:
    /// Both must outlive it.
    Course(const Motion& motion, const MovingBody& body) : motion_(motion), body_(body) {}

    /// None where it is not there.
    [[nodiscard]] std::optional<glm::dmat4> at(double time) const;

    /// The way of a point, as it was at first, while the time runs, with `most` the longest piece; in parts where the
    /// body is away or jumps in between.
    [[nodiscard]] std::vector<std::vector<glm::dvec3>> way(const glm::dvec3& point, double from, double to,
                                                           double most) const;

    [[nodiscard]] const MovingBody& body() const { return body_; }

  private:
    [[nodiscard]] bool jumps(double from, double to) const;

    const Motion& motion_;
    const MovingBody& body_;
};

/// The middle of the body's box when it was first there.
[[nodiscard]] inline glm::dvec3 middle_of(const MovingBody& body) {
    return 0.5 * (body.box.lo + body.box.hi);
}

}  // namespace ui
