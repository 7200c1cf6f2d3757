// When two bodies come to touch, by how near they are: conservative advancement (Mirtich 1996) along their screws.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <vector>

#include "ui/pipeline/motion/course.h"
#include "ui/pipeline/motion/rigid_mesh.h"

namespace ui {

/// One of two: a body that moves, or what stands still.
struct ContactSide {
    const RigidMesh& mesh;
    const MovingBody* body = nullptr;

    [[nodiscard]] std::optional<glm::dmat4> at(const Motion& motion, double time) const;
};

struct Touch {
    double time = 0;
    glm::dvec3 point{0.0};  ///< World units: between the nearest points.
};

/// They touch where their surfaces come as near as the motion is off by, or where one is inside the other; they are
/// apart again where they are kParted of the smaller one away. What is led by screws between samples comes nearer by no
/// more than the way of the corners of its box, so steps as long as the two cannot reach each other within pass no
/// contact. Steps are not shorter than 1/kSteps of a sample interval, though: what such a step may have passed is
/// looked for where the distance has a valley. While they touch, steps are as long as they take to part so far.
class Approach {
  public:
    static constexpr int kSteps = 500;
    static constexpr double kParted = 1e-3;

    /// All must outlive it.
    Approach(const Motion& motion, ContactSide a, ContactSide b, const std::stop_token& stop);

    /// The times between `from` and `to` at which they begin to touch; what touches at `from` does not begin to. Throws
    /// base::Stopped where it was asked for.
    [[nodiscard]] std::vector<Touch> find(double from, double to);

  private:
    enum class State { Touching, Near, Apart };
    struct Here {
        double time = 0;
        RigidMesh::Near near;
    };
    /// None where one of them is not there.
    [[nodiscard]] std::optional<Here> look(double time) const;
    /// Neither touching nor inside each other.
    [[nodiscard]] bool outside(const Here& here) const;
    /// The highest speed of the one against the other between two times of one interval; 0 where they move as one.
    [[nodiscard]] double speed(double from, double to) const;
    void begin(double time);
    void pass(double from, double to);
    void take(const Here& here, bool safe);
    void near(const Here& here);
    [[nodiscard]] Here first_touch(Here apart, Here touching) const;
    [[nodiscard]] Here nearest_between(double from, double to) const;
    [[nodiscard]] Here lowest() const;
    void add(const Here& at) { found_.push_back({at.time, 0.5 * (at.near.a + at.near.b)}); }

    const Motion& motion_;
    ContactSide a_, b_;
    const std::stop_token& stop_;
    double none_ = 0, touching_ = 0, parted_ = 0;  ///< World units; `none_`: what rounding leaves of no distance.
    State state_ = State::Touching;
    std::optional<Here> here_, before_;       ///< The last two places, …
    bool safe_ = true;                        ///< … and whether the step between them passed no contact.
    Here lowest_;                             ///< Since they are near: the nearest place, …
    double lowest_from_ = 0, lowest_to_ = 0;  ///< … and the times of those before and behind it.
    std::vector<Touch> found_;
};

}  // namespace ui
