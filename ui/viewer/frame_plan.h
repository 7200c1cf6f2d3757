// What to draw next, so that input never waits long: coarse while things move, then whole, then sample by sample.
#pragma once

#include <map>
#include <optional>

namespace ui {

/// One sample of the picture, at its size divided by `divisor`. Sample 0 begins a new picture.
struct PictureStep {
    int divisor = 1;
    int sample = 0;
    bool operator==(const PictureStep&) const = default;
};

/// Times are seconds of any steady clock.
class FramePlan {
  public:
    /// The picture that is wanted has changed in a way that the camera's motion does (another view of the same things).
    void moved(double now);
    /// Something else has changed, such as the model or the style: what a picture costs is only a guess now.
    void replaced(double now);
    void set_samples(int samples) { samples_ = samples; }
    /// Steps can be stopped, so that those that take long need not wait until nothing is likely to change.
    void set_stoppable(bool stoppable) { stoppable_ = stoppable; }

    /// The next step; none where the picture is finished, or where it rests until the motion ends.
    [[nodiscard]] std::optional<PictureStep> next(double now) const;
    /// The step was drawn and took so long.
    void drawn(const PictureStep& step, double seconds);
    /// The same for a step of a picture that is not wanted any more: only its cost is of use.
    void measured(const PictureStep& step, double seconds) { cost_[step.divisor] = {seconds, ++steps_}; }
    /// Is the step, which is being drawn, to be stopped for the sake of the picture that is wanted now? Not where it is
    /// as quick as what would be drawn in its place: something is to be seen while things move.
    [[nodiscard]] bool hinders(const PictureStep& step) const;
    /// The picture cannot be drawn; there is nothing to do until something changes.
    void give_up();

    /// Seconds until next() may have a step; none where only a change brings one.
    [[nodiscard]] std::optional<double> wait(double now) const;
    /// The picture is whole and has all its samples.
    [[nodiscard]] bool finished() const { return !begin_ && shown_.divisor == 1 && shown_.sample + 1 >= samples_; }

  private:
    [[nodiscard]] int affordable(double budget) const;
    [[nodiscard]] double predicted(int divisor) const;

    int samples_ = 1;
    bool stoppable_ = false;
    bool begin_ = true;     ///< Nothing of the wanted picture is drawn yet.
    bool replaced_ = true;  ///< … and it is another than before, not another view of it.
    double changed_at_ = 0;
    PictureStep shown_;
    struct Cost {
        double seconds = 0;  ///< Of the last sample …
        long step = 0;       ///< … and which one it was.
    };
    std::map<int, Cost> cost_;  ///< By divisor.
    long steps_ = 0;            ///< Samples drawn.
};

}  // namespace ui
