// Speed against error, knob by knob. See tools/benchmark and docs/PERFORMANCE.md.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "tests/bench/knobs.h"
#include "tests/support/output.h"
#include "ui/pipeline/heap.h"

namespace {

using test_support::write_output;

struct Settings {
    std::string models = "models", json, markdown, plots, plots_in_text = "pictures/performance";
    std::vector<std::string> only{"widget", "spanner", "pipe_tee", "torture"}, deep{"padlock", "gears"}, knobs;
    bench::KnobOptions options;
};

std::vector<bench::KnobRow> run(const Settings& settings, gl::Context& context) {
    bench::DrawerSet drawers(context, 2 * settings.options.side);
    if (!drawers.missing().empty()) {
        std::cerr << "left out: " << drawers.missing() << '\n';
    }
    const auto wanted = [&](const char* knob) {
        return settings.knobs.empty() ||
               std::find(settings.knobs.begin(), settings.knobs.end(), knob) != settings.knobs.end();
    };
    std::vector<bench::KnobRow> rows;
    const auto read = [&](const std::string& name) {
        std::cerr << name << '\n';
        return bench::from_file((std::filesystem::path(settings.models) / (name + ".scad")).string());
    };
    for (const std::string& name : settings.only) {
        const bench::Subject subject = read(name);
        if (wanted("resolution")) {
            turn_resolution(drawers, subject, settings.options, rows);
        }
        if (wanted("samples")) {
            turn_samples(drawers, subject, settings.options, rows);
        }
        if (wanted("layers")) {
            turn_layers(drawers, subject, settings.options, rows);
        }
        if (wanted("depth")) {
            turn_depth(subject, rows);
        }
    }
    for (const std::string& name : settings.deep) {
        if (wanted("minimal fraction")) {
            turn_minimal_fraction(context, read(name), settings.options, rows);
        }
    }
    if (wanted("tessellation")) {
        std::cerr << "tessellation\n";
        turn_tessellation(drawers, settings.options, rows);
    }
    return rows;
}

}  // namespace

int main(int argc, char** argv) {
    ui::keep_freed_memory();
    Settings settings;
    CLI::App app("CPU time and error of the engines and of OpenCSG, as one knob after the other is turned.");
    app.add_option("--models", settings.models, "Folder of models")->capture_default_str();
    app.add_option("--only", settings.only, "Names of models")->delimiter(',')->capture_default_str();
    app.add_option("--deep", settings.deep, "Names of models for the minimal fraction")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--knobs", settings.knobs,
                   "resolution, samples, layers, minimal fraction, tessellation, depth (all)")
        ->delimiter(',');
    app.add_option("--side", settings.options.side, "Of pictures, in pixels: a power of two from 64 to 2048")
        ->capture_default_str()
        ->check(CLI::IsMember({64, 128, 256, 512, 1024, 2048}));
    app.add_option("--repeat", settings.options.repeat, "Frames per figure")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--json", settings.json, "Write JSON; - is standard output");
    app.add_option("--markdown", settings.markdown, "Write tables; - is standard output");
    app.add_option("--plots", settings.plots, "Folder for plots (SVG)");
    app.add_option("--plots-in-text", settings.plots_in_text, "Where the tables' text finds the plots");
    CLI11_PARSE(app, argc, argv);
    try {
        const auto context = gl::create_context(gl::ContextKind::Auto);
        const auto rows = run(settings, *context);
        write_output(settings.json, to_json(rows).dump(1));
        write_output(settings.markdown, to_markdown(rows, settings.plots_in_text));
        if (!settings.plots.empty()) {
            std::filesystem::create_directories(settings.plots);
            for (const auto& [name, text] : to_plots(rows)) {
                write_output(settings.plots + "/" + name, text);
            }
        }
    } catch (const std::exception& error) {
        std::cerr << "csgscope_knobs: error: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
