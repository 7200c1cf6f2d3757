// Errors of the engines over the families: DESIGN, section 5.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/goldfeather/engine_test.h"
#include "tests/opencsg/opencsg.h"
#include "tests/stability/family.h"

namespace stability {

/// What an engine made of a picture, against the exact ray caster.
struct Errors {
    bool drawn = false;     ///< False: refused (a sum of products over budget), or too much for this engine here.
    std::size_t wrong = 0;  ///< Pixels outside the band that differ: layers, leaf, orientation, plane or depth.
    std::size_t coverage = 0, layers = 0, normal = 0;  ///< Pixels that differ, band and all.
    double depth_rms = 0, depth_most = 0;              ///< Of first surfaces, over the scene's diagonal, band and all.
    double milliseconds = 0;                           ///< Wall time of the frame.
};

struct Measure {
    std::string family, engine;
    double level = 0;
    bool orthographic = false;
    std::size_t pixels = 0;     ///< With something along the ray.
    std::size_t undecided = 0;  ///< Of those, in the band.
    Errors errors;
};

struct SweepOptions {
    int size = 48;                      ///< Side of the pictures in pixels.
    std::size_t most_leaves = 1000000;  ///< Levels with more are left out.
    bool few_levels = false;            ///< The first, the middle and the last level only.
};

/// Draws families with every engine that can be had here: "goldfeather", "lists", "lists-cpu", "scs" (the first layer,
/// where it can draw the family), and "OpenCSG" for comparison.
class Sweep {
  public:
    explicit Sweep(const SweepOptions& options);

    [[nodiscard]] std::vector<Measure> run(const Family& family);
    /// Engines that cannot be had here, with the reason.
    [[nodiscard]] const std::vector<std::string>& missing() const { return missing_; }

  private:
    struct Engine {
        std::string name;
        std::unique_ptr<comparison::Engine> engine;
    };
    void measure(const Family& family, double level, std::vector<Measure>& measures);

    SweepOptions options_;
    std::vector<Engine> engines_;
    std::unique_ptr<opencsg::OpenCsg> opencsg_;
    std::vector<std::string> missing_;
};

}  // namespace stability
