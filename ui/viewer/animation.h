// $t and how it runs: from 0 to 1 in steps, in real time as far as the models follow.
#pragma once

namespace ui {

/// Times are seconds of any steady clock.
class Animation {
  public:
    void set_steps(int steps);  ///< At least 1.
    void set_rate(double steps_per_second) { rate_ = steps_per_second; }
    /// It stays where it is, on a step of the cycle.
    void go_to(int step);
    void play(bool plays, double now);

    /// True where it is another step by now. To be asked for when the model of the one before is there.
    [[nodiscard]] bool advance(double now);

    [[nodiscard]] bool plays() const { return plays_; }
    [[nodiscard]] int steps() const { return steps_; }
    [[nodiscard]] double rate() const { return rate_; }
    [[nodiscard]] int step() const { return step_; }
    [[nodiscard]] double time() const { return static_cast<double>(step_) / steps_; }  ///< $t

  private:
    int steps_ = 100, step_ = 0;
    double rate_ = 20;
    bool plays_ = false;
    double began_ = 0;  ///< When step first_ was.
    int first_ = 0;
};

}  // namespace ui
