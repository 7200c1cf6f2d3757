// Speed against error, as one knob after the other is turned: resolution, samples, layers, depth precision,
// tessellation and the minimal fraction of pixels that ends peeling.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/drawer.h"
#include "tests/bench/measure.h"
#include "tests/bench/subject.h"

namespace bench {

/// One engine on one model, with the knob at one value.
struct KnobRow {
    std::string knob, model, engine;
    double value = 0;  ///< Infinite: all there are.
    double cpu = 0;    ///< Milliseconds of CPU time.
    double error = 0;  ///< Percent, see KnobInfo::error.
};

/// What is shown of a knob.
struct KnobInfo {
    std::string name;
    std::string what;   ///< A sentence on what was measured.
    std::string error;  ///< Of what the error is.
    bool times = true;  ///< False: the knob does not change what a picture costs; error is plotted over its values.
    std::string value;  ///< What its values are.
};

struct KnobOptions {
    int repeat = 3;
    int side = 512;  ///< Of pictures, where the knob is another one.
};

/// Sides from 64 to 1,024 pixels, and samples a pixel at a quarter of `side`, against a picture of 4,096² samples.
void turn_resolution(DrawerSet& drawers, const Subject& subject, const KnobOptions& options,
                     std::vector<KnobRow>& rows);
void turn_samples(DrawerSet& drawers, const Subject& subject, const KnobOptions& options, std::vector<KnobRow>& rows);
/// So many layers, against all.
void turn_layers(DrawerSet& drawers, const Subject& subject, const KnobOptions& options, std::vector<KnobRow>& rows);
/// Sides of curved leaves, against the finest.
void turn_tessellation(DrawerSet& drawers, const KnobOptions& options, std::vector<KnobRow>& rows);
/// Formats of depth, with planes as the engines have them and with depth interpolated between vertices, against the ray
/// caster.
void turn_depth(const Subject& subject, std::vector<KnobRow>& rows);

/// The least share of pixels for which peeling goes on (--minimal-fraction), blueprints of all layers, against 0.
void turn_minimal_fraction(gl::Context& context, const Subject& subject, const KnobOptions& options,
                           std::vector<KnobRow>& rows);

[[nodiscard]] const std::vector<KnobInfo>& knobs();
[[nodiscard]] nlohmann::ordered_json to_json(const std::vector<KnobRow>& rows);
/// A table and a plot for each knob. `plots`: where the text finds them.
[[nodiscard]] std::string to_markdown(const std::vector<KnobRow>& rows, const std::string& plots);
/// {file name, SVG}.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> to_plots(const std::vector<KnobRow>& rows);

}  // namespace bench
