#include "ui/viewer/animation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

void Animation::set_steps(int steps) {
    const double time = this->time();
    steps_ = std::max(steps, 1);
    step_ = first_ = std::min(static_cast<int>(std::lround(time * steps_)), steps_ - 1);
}

void Animation::go_to(int step) {
    step_ = ((step % steps_) + steps_) % steps_;
    plays_ = false;
}

void Animation::play(bool plays, double now) {
    plays_ = plays;
    began_ = now;
    first_ = step_;
}

bool Animation::advance(double now) {
    if (!plays_) {
        return false;
    }
    // What there was no time for is left out.
    const double passed = std::floor((now - began_) * rate_);
    const int next = static_cast<int>(std::fmod(first_ + passed, steps_));
    return std::exchange(step_, next) != next;
}

}  // namespace ui
