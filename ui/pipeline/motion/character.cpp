#include "ui/pipeline/motion/character.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/pipeline/motion/box_corners.h"
#include "ui/pipeline/motion/rigid_motion.h"

namespace ui {

namespace {

/// Directions that differ by less are one; and, of the size of the model, points.
constexpr double kParallelAxes = 1e-6;

struct Step {
    Screw screw;
    double time = 0, duration = 0;
    double way = 0;  ///< Of the middle of the box.
};

class Characterization {
  public:
    Characterization(const Motion& motion, const MovingBody& body) : motion_(motion), body_(body) {
        size_ = std::max(1e-300, body.box.empty() ? 0 : body.box.diagonal());
    }

    Character run() {
        if (!collect()) {
            result_.kind = Character::Kind::Deforms;
            return result_;
        }
        if (steps_.empty()) {
            return result_;
        }
        decide();
        return result_;
    }

  private:
    /// False where a step is no rigid motion.
    bool collect() {
        constexpr std::size_t kNoneBefore = ~std::size_t{0};
        std::size_t before = kNoneBefore;
        std::optional<glm::dvec3> first, last;
        for (std::size_t i = 0; i < body_.poses.size(); ++i) {
            if (!body_.poses[i]) {
                before = kNoneBefore;
                continue;
            }
            first = first ? first : body_.poses[i]->center;
            last = body_.poses[i]->center;
            if (before != kNoneBefore && body_.poses[before]->motion != body_.poses[i]->motion) {
                if (!add(before, i)) {
                    return false;
                }
            }
            before = i;
        }
        result_.way_net = first ? glm::distance(*first, *last) : 0;
        return true;
    }

    bool add(std::size_t i, std::size_t j) {
        const Pose &a = *body_.poses[i], &b = *body_.poses[j];
        const auto screw = screw_of(b.motion * glm::inverse(a.motion));
        if (!screw) {
            return false;
        }
        size_ = std::max({size_, glm::length(a.center), glm::length(b.center)});
        Step step{*screw, 0.5 * (motion_.times[i] + motion_.times[j]), motion_.times[j] - motion_.times[i], 0};
        step.way = way_of(*screw, a.center);
        result_.way += step.way;
        result_.turned += screw->angle;
        if (!body_.box.empty() && !jumps(i, j)) {
            for (const glm::dvec3& corner : corners_of(body_.box)) {
                const double speed = way_of(*screw, glm::dvec3(a.motion * glm::dvec4(corner, 1))) / step.duration;
                if (speed > result_.fastest) {
                    result_.fastest = speed;
                    result_.fastest_at = step.time;
                }
            }
        }
        steps_.push_back(step);
        return true;
    }

    /// Along the helix that the screw leads a point.
    static double way_of(const Screw& screw, const glm::dvec3& from) {
        const glm::dvec3 aside = from - screw.point;
        const double radius = glm::length(aside - glm::dot(aside, screw.axis) * screw.axis);
        return std::hypot(screw.angle * radius, screw.along);
    }

    [[nodiscard]] bool jumps(std::size_t i, std::size_t j) const {
        return std::any_of(body_.events.begin(), body_.events.end(), [&](const MotionEvent& event) {
            return event.kind == MotionEvent::Kind::Jumps && event.after >= motion_.times[i] &&
                   event.before <= motion_.times[j];
        });
    }

    void decide() {
        const bool turns = result_.turned > kParallelAxes;
        const auto longest = std::max_element(steps_.begin(), steps_.end(), [&](const Step& a, const Step& b) {
            return turns ? a.screw.angle < b.screw.angle : a.screw.along < b.screw.along;
        });
        const auto first = std::find_if(steps_.begin(), steps_.end(), [&](const Step& s) {
            return turns ? s.screw.angle > kParallelAxes : s.screw.along > kParallelAxes * size_;
        });
        Screw main = longest->screw;
        if (first != steps_.end() && glm::dot(first->screw.axis, main.axis) < 0) {
            main.axis = -main.axis;
        }
        double net = 0, along = 0;
        bool fixed = true, slips = false;
        for (const Step& s : steps_) {
            const glm::dvec3& axis = s.screw.axis;
            const double sense = glm::dot(axis, main.axis) < 0 ? -1 : 1;
            const bool small = (turns ? s.screw.angle : s.screw.along / size_) < kParallelAxes;
            // What a short turn's axis is off by, it is off by in little.
            const double weight = turns ? s.screw.angle : s.screw.along / size_;
            const glm::dvec3 apart = s.screw.point - main.point;
            const double off =
                std::max(glm::length(glm::cross(axis, main.axis)),
                         turns ? glm::length(apart - glm::dot(apart, main.axis) * main.axis) / size_ : 0);
            fixed = fixed && (small || off * std::min(1.0, weight) < kParallelAxes);

            slips = slips || (turns && std::abs(s.screw.along) > kParallelAxes * size_);
            net += sense * s.screw.angle;
            result_.turned_least = std::min(result_.turned_least, net);
            result_.turned_most = std::max(result_.turned_most, net);
            along += sense * s.screw.along;
        }
        if (!fixed) {
            result_.kind = turns ? Character::Kind::Moves : Character::Kind::Travels;
            return;
        }
        result_.kind = !turns ? Character::Kind::Slides : slips ? Character::Kind::Screws : Character::Kind::Turns;
        result_.axis = main.axis;
        result_.point = main.point;
        result_.turned_net = net;
        result_.way_net = turns && !slips ? result_.way_net : along;
    }

    const Motion& motion_;
    const MovingBody& body_;
    Character result_;
    std::vector<Step> steps_;
    double size_ = 0;
};

}  // namespace

Character character_of(const Motion& motion, const MovingBody& body) {
    return Characterization(motion, body).run();
}

const char* name(Character::Kind kind) {
    switch (kind) {
        case Character::Kind::Stays:
            return "stays";
        case Character::Kind::Turns:
            return "turns";
        case Character::Kind::Slides:
            return "slides";
        case Character::Kind::Screws:
            return "screws";
        case Character::Kind::Travels:
            return "travels";
        case Character::Kind::Moves:
            return "moves";
        case Character::Kind::Deforms:
            return "deforms";
    }
    return "";
}

}  // namespace ui
