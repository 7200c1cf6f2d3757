// Engines side by side: cost and error on the same models, in one run on one machine.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/bench/drawer.h"
#include "tests/bench/measure.h"
#include "tests/bench/subject.h"

namespace bench {

/// One engine on one model.
struct Compared {
    std::string model;
    double family_size = 0;
    int side = 0;  ///< Of the picture, in pixels.
    std::size_t leaves = 0, products = 0, triangles = 0;
    std::string engine;  ///< "floor", "lists-cpu", "lists-cpu all", "goldfeather", "OpenCSG Goldfeather", …
    bool drawn = false;
    Time time;
    double wrong = 0;  ///< Percent of the pixels tested, outside the band, whose first surface is not the true one.
    double peak = 0;   ///< Megabytes of the process when the engine was done: at most what it needed.
};

class Comparison {
  public:
    /// `largest`: side of the largest picture.
    Comparison(gl::Context& context, int largest, int repeat);

    /// Measures all engines; every frame ends with the first surface, "all" with all of them: in textures, or in main
    /// memory, where those that the CPU finds are painted from.
    [[nodiscard]] std::vector<Compared> run(const Subject& subject, int side);
    /// What is left out here, and why.
    [[nodiscard]] const std::string& missing() const { return drawers_.missing(); }

  private:
    gl::Context& context_;
    int repeat_;
    DrawerSet drawers_;
};

[[nodiscard]] nlohmann::ordered_json to_json(const std::vector<Compared>& rows);
/// Tables: means over the gallery, every model, and the families.
[[nodiscard]] std::string to_markdown(const std::vector<Compared>& rows);
/// Plots as SVG: {file name, text}. Speed against error, and cost against size for each family.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> to_plots(const std::vector<Compared>& rows);

}  // namespace bench
