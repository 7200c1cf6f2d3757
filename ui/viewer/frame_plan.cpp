#include "ui/viewer/frame_plan.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace ui {

namespace {

constexpr std::array kDivisors{1, 2, 3, 4, 6};
// Seconds that a step may take while the camera moves, and for the first look at something new.
constexpr double kMotionBudget = 0.05, kLookBudget = 0.3;
// … and while it rests, as long as it may well move again.
constexpr double kRestBudget = 1;
/// Seconds without change after which the camera counts as still, and after which a picture may take as long as it
/// takes.
constexpr double kStill = 0.12, kIdle = 1.5;
/// Samples after which what a picture of another size took is forgotten: the machine may have been busy then.
constexpr long kForgotten = 25;

}  // namespace

void FramePlan::moved(double now) {
    begin_ = true;
    changed_at_ = now;
}

void FramePlan::replaced(double now) {
    begin_ = replaced_ = true;
    changed_at_ = now - kStill;  // Nothing moves: the whole picture follows at once.
}

double FramePlan::predicted(int divisor) const {
    // From the measured divisor that is nearest: the cost has a part that does not shrink with the picture. What was
    // measured long ago is what a coarser picture would lead one to expect by now, where that is less.
    const auto exact = cost_.find(divisor);
    auto known = cost_.upper_bound(divisor);
    while (known != cost_.end() && steps_ - known->second.step >= kForgotten) {
        ++known;
    }
    if (exact != cost_.end() && (known == cost_.end() || steps_ - exact->second.step < kForgotten)) {
        return exact->second.seconds;
    }
    if (known == cost_.end()) {
        known = std::prev(cost_.end());
    }
    const double pixels = static_cast<double>(known->first * known->first) / static_cast<double>(divisor * divisor);
    const double expected = known->second.seconds * pixels;
    return exact != cost_.end() ? std::min(exact->second.seconds, expected) : expected;
}

int FramePlan::affordable(double budget) const {
    if (cost_.empty()) {
        return kDivisors.back();
    }
    for (const int divisor : kDivisors) {
        if (predicted(divisor) <= budget) {
            return divisor;
        }
    }
    return kDivisors.back();
}

std::optional<PictureStep> FramePlan::next(double now) const {
    if (begin_) {
        return PictureStep{affordable(replaced_ ? kLookBudget : kMotionBudget), 0};
    }
    const double still = now - changed_at_;
    if (still < kStill || finished()) {
        return std::nullopt;
    }
    if (shown_.divisor == 1) {
        return PictureStep{1, shown_.sample + 1};
    }
    const int finer = affordable(kRestBudget);
    if (still < kIdle && finer < shown_.divisor) {
        return PictureStep{finer, 0};
    }
    return still >= kIdle || stoppable_ ? std::optional(PictureStep{1, 0}) : std::nullopt;
}

bool FramePlan::hinders(const PictureStep& step) const {
    return begin_ && (step.sample > 0 || step.divisor < affordable(replaced_ ? kLookBudget : kMotionBudget));
}

void FramePlan::drawn(const PictureStep& step, double seconds) {
    if (replaced_) {
        cost_.clear();  // Of something else.
    }
    cost_[step.divisor] = {seconds, ++steps_};
    shown_ = step;
    begin_ = replaced_ = false;
}

void FramePlan::give_up() {
    shown_ = {1, samples_ - 1};
    begin_ = replaced_ = false;
}

std::optional<double> FramePlan::wait(double now) const {
    if (begin_) {
        return 0;
    }
    if (finished()) {
        return std::nullopt;
    }
    if (next(now)) {
        return 0;
    }
    const double still = now - changed_at_;
    return (still < kStill ? kStill : kIdle) - still;
}

}  // namespace ui
