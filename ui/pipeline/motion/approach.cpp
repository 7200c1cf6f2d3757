#include "ui/pipeline/motion/approach.h"

#include <algorithm>
#include <cmath>

#include "base/stop.h"
#include "ui/pipeline/motion/box_corners.h"
#include "ui/pipeline/motion/rigid_motion.h"

namespace ui {

namespace {

/// The way of a corner of the box between two places, at most.
double longest_way(const csg::Box& box, const glm::dmat4& from, const glm::dmat4& to) {
    constexpr int kPieces = 8;
    constexpr double kChords = 1.03;  // Arcs are longer than chords: of half a turn in eight by 0.6 %.
    double most = 0;
    for (const glm::dvec3& corner : corners_of(box)) {
        double length = 0;
        glm::dvec3 before(from * glm::dvec4(corner, 1));
        for (int k = 1; k <= kPieces; ++k) {
            const glm::dvec3 next(between(from, to, double{1} * k / kPieces) * glm::dvec4(corner, 1));
            length += glm::distance(before, next);
            before = next;
        }
        most = std::max(most, length);
    }
    return kChords * most;
}

}  // namespace

std::optional<glm::dmat4> ContactSide::at(const Motion& motion, double time) const {
    return body != nullptr ? Course(motion, *body).at(time) : glm::dmat4(1.0);
}

Approach::Approach(const Motion& motion, ContactSide a, ContactSide b, const std::stop_token& stop)
    : motion_(motion), a_(a), b_(b), stop_(stop) {
    const double size = std::max(1e-300, a.mesh.box().diagonal() + b.mesh.box().diagonal());
    constexpr double kNone = 1e-13, kRounding = 1e-9;
    none_ = kNone * size;
    // What the motion is off by between samples, of either.
    touching_ = 2 * motion.error + kRounding * size;
    parted_ = std::max(2 * touching_, kParted * std::min(a.mesh.box().diagonal(), b.mesh.box().diagonal()));
}

std::optional<Approach::Here> Approach::look(double time) const {
    base::end_if_asked(stop_);
    const auto a = a_.at(motion_, time), b = b_.at(motion_, time);
    return a && b ? std::optional(Here{time, RigidMesh::nearest(a_.mesh, *a, b_.mesh, *b)}) : std::nullopt;
}

bool Approach::outside(const Here& here) const {
    if (here.near.distance <= none_) {
        return false;
    }
    const auto a = a_.at(motion_, here.time), b = b_.at(motion_, here.time);
    return a && b && !b_.mesh.holds(glm::dvec3(glm::inverse(*b) * glm::dvec4(here.near.a, 1))) &&
           !a_.mesh.holds(glm::dvec3(glm::inverse(*a) * glm::dvec4(here.near.b, 1)));
}

double Approach::speed(double from, double to) const {
    const auto a = a_.at(motion_, from), b = b_.at(motion_, from), next_a = a_.at(motion_, to),
               next_b = b_.at(motion_, to);
    if (!a || !b || !next_a || !next_b) {
        return 0;
    }
    if (a_.body != nullptr && b_.body != nullptr) {
        // On the same carriage, or about the same axle, they are at rest.
        const double against = longest_way(a_.mesh.box(), glm::inverse(*b) * *a, glm::inverse(*next_b) * *next_a);
        const double half = 0.5 * (from + to);
        const auto middle_a = a_.at(motion_, half), middle_b = b_.at(motion_, half);
        const double so_far = longest_way(a_.mesh.box(), glm::inverse(*b) * *a, glm::inverse(*middle_b) * *middle_a);
        if (std::max(against, so_far) < touching_) {
            return 0;
        }
    }
    return (longest_way(a_.mesh.box(), *a, *next_a) + longest_way(b_.mesh.box(), *b, *next_b)) / (to - from);
}

/// The first place where they are not outside each other, to the rounding of times.
Approach::Here Approach::first_touch(Here apart, Here touching) const {
    for (;;) {
        const double middle = 0.5 * (apart.time + touching.time);
        const auto here = middle > apart.time && middle < touching.time ? look(middle) : std::nullopt;
        if (!here) {
            return touching;
        }
        (outside(*here) ? apart : touching) = *here;
    }
}

/// Of one valley of the distance (golden section, Kiefer 1953).
Approach::Here Approach::nearest_between(double from, double to) const {
    constexpr double kGolden = 0.6180339887498949;
    constexpr int kRounds = 60;
    std::optional<Here> left = look(to - kGolden * (to - from)), right = look(from + kGolden * (to - from));
    for (int i = 0; i < kRounds && left && right; ++i) {
        if (left->near.distance <= right->near.distance) {
            to = right->time;
            right = left;
            left = look(to - kGolden * (to - from));
        } else {
            from = left->time;
            left = right;
            right = look(from + kGolden * (to - from));
        }
    }
    const Here nowhere{from, {INFINITY, {}, {}}};
    return left && right && right->near.distance < left->near.distance ? *right : left.value_or(nowhere);
}

/// As near as what touches, or on the way from there.
void Approach::near(const Here& here) {
    // What is lower by less is noise: of what comes to rest the first place counts.
    const double noise = 1e-3 * touching_;
    if (state_ == State::Apart || here.near.distance < lowest_.near.distance - noise) {
        lowest_ = here;
        lowest_from_ = here_ ? here_->time : here.time;
        lowest_to_ = here.time;
    } else if (lowest_to_ <= lowest_.time) {
        lowest_to_ = here.time;
    }
    state_ = State::Near;
}

Approach::Here Approach::lowest() const {
    const Here between = nearest_between(lowest_from_, lowest_to_);
    return between.near.distance < lowest_.near.distance ? between : lowest_;
}

/// The next place. `safe`: the step to it is one that passes no contact.
void Approach::take(const Here& here, bool safe) {
    const double d = here.near.distance;
    switch (state_) {
        case State::Touching:
            if (d > parted_ && outside(here)) {
                state_ = State::Apart;
            }
            break;
        case State::Near:
        case State::Apart:
            if (d <= none_ || (!safe && !outside(here))) {
                add(here_ ? first_touch(*here_, here) : here);
                state_ = State::Touching;
            } else if (d <= touching_ || (state_ == State::Near && d <= parted_)) {
                near(here);
            } else if (state_ == State::Near) {
                near(here);
                add(lowest());
                state_ = State::Apart;
            } else if (state_ == State::Apart && here_ && before_ && !(safe && safe_) &&
                       here_->near.distance < before_->near.distance && here_->near.distance <= d) {
                const Here lowest = nearest_between(before_->time, here.time);
                if (lowest.near.distance <= touching_) {
                    add(outside(lowest) ? lowest : first_touch(*before_, lowest));
                }
            }
            break;
    }
    before_ = here_;
    here_ = here;
    safe_ = safe;
}

void Approach::begin(double time) {
    before_.reset();
    here_ = look(time);
    if (!here_) {
        state_ = State::Apart;  // What is not there touches nothing.
    } else if (here_->near.distance > touching_ && outside(*here_)) {
        state_ = State::Apart;
    }
}

void Approach::pass(double from, double to) {
    if (!here_) {
        begin(from);
    }
    const double fastest = here_ ? speed(from, to) : 0;
    if (!(fastest > 0)) {
        return;
    }
    const double least_step = (to - from) / kSteps;
    while (here_ && here_->time < to) {
        const double d = here_->near.distance;
        const double free = (state_ == State::Touching ? std::max(d, 2 * parted_) : d) / fastest;
        const auto next = look(std::min(to, here_->time + std::max(free, least_step)));
        if (next) {
            take(*next, state_ == State::Touching || free >= least_step);
        } else {
            here_.reset();
        }
    }
}

std::vector<Touch> Approach::find(double from, double to) {
    std::vector<double> times{from};
    for (const double t : motion_.times) {
        if (t > from && t < to) {
            times.push_back(t);
        }
    }
    times.push_back(to);
    found_.clear();
    state_ = State::Touching;
    here_.reset();
    begin(from);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        if (here_) {
            here_->time = times[i];  // Where they did not move against each other.
        }
        pass(times[i], times[i + 1]);
    }
    if (state_ == State::Near) {
        add(lowest());  // The way ends where they are as near as can be told.
    }
    return std::move(found_);
}

}  // namespace ui
