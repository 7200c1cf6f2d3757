#include "ui/command_line/compare_options.h"

#include <map>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "ui/command_line/files.h"
#include "ui/command_line/option_values.h"

namespace ui {

CompareOptions read_compare_options(const std::vector<std::string>& arguments) {
    CompareOptions o;
    std::string camera, projection = "p", engine(o.engine->name);
    CLI::App app("csgscope compare draws a model and compares all layers of the picture with a mesh.",
                 "csgscope compare");
    app.add_option("file", o.input, "The .scad file")->required();
    app.add_option("--against", o.against,
                   "cgal (the exact mesh), openscad (its tree, mesh and picture), FILE.stl, FILE.off or FILE.png");
    std::map<std::string, const goldfeather::EngineInfo*> engines;
    std::string all, first;
    for (const goldfeather::EngineInfo& each : goldfeather::engines()) {
        engines.emplace(each.name, &each);
        const bool finds_all = each.capabilities.most_layers == goldfeather::kAllLayers;
        (finds_all ? all : first) += std::string(each.name) + ", ";
    }
    app.add_option("--engine", engine,
                   fmt::format("{}or {}of which the first layer is compared ({})", all, first, o.engine->name))
        ->check(CLI::IsMember(engines));
    app.add_option("--views", o.views, "Views spread over the sphere, of both projections in turn (1)")
        ->check(CLI::Range(1, 100));
    app.add_option("--camera", camera, "One view instead: the numbers of csgscope --camera");
    app.add_option("--projection", projection, "Of --camera: o (orthographic) or p (perspective, default)")
        ->check(CLI::IsMember({"o", "p"}));
    app.add_option("--imgsize", o.size, "Width and height in pixels (256)")->check(CLI::Range(16, 4096));
    app.add_option("--report", o.report, "Folder for report.html, report.json and pictures of the differences");
    app.add_option("--tolerance", o.tolerance, "Largest share of wrong pixels outside the band (0)")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--reference", o.reference, "A picture to compare with, as --against FILE.png");
    app.add_option("--reference-threshold", o.reference_threshold, "Largest share of pixels that may differ (0.01)")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--time-limit", o.time_limit, "End with an error after so many seconds")
        ->check(CLI::PositiveNumber & CLI::Range(0.0, 1e9));
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp&) {
        write_output("-", app.help());
        o.input.clear();
        return o;
    } catch (const CLI::ParseError& error) {
        throw UsageError(fmt::format("compare: {}", error.what()));
    }
    o.engine = engines.at(engine);
    if (o.against.ends_with(".png")) {
        o.reference = o.against;
    }
    if (!camera.empty()) {
        if (o.views != 1) {
            throw UsageError("compare: --camera is one view; --views has its own");
        }
        o.camera = read_camera(camera);
        o.camera->projection = projection == "o" ? base::Projection::Orthographic : base::Projection::Perspective;
    }
    return o;
}

}  // namespace ui
