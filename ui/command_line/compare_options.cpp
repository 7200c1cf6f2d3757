#include "ui/command_line/compare_options.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "ui/command_line/files.h"
#include "ui/command_line/option_table.h"
#include "ui/command_line/option_values.h"
#include "ui/command_line/options.h"

namespace ui {

CompareOptions read_compare_options(const std::vector<std::string>& arguments) {
    CompareOptions o;
    std::string parts, camera, size, projection = "p", engine(o.engine->name);
    OptionTable table(
        "csgscope compare draws a model and compares all layers of the picture with a mesh; of two files, "
        "versions of one model, it tells what has changed.",
        "csgscope compare");
    table.add({"file", "The .scad file"}, o.input, true);
    table.add({"later", "A later version of it"}, o.later);
    table.add(
        {"--against", "cgal (the exact mesh), openscad (its tree, mesh and picture), FILE.stl, FILE.off or FILE.png"},
        o.against);
    std::map<std::string, const goldfeather::EngineInfo*> engines;
    std::vector<std::string> names;
    std::string all, first;
    for (const goldfeather::EngineInfo& each : goldfeather::engines()) {
        engines.emplace(each.name, &each);
        names.emplace_back(each.name);
        const bool finds_all = each.capabilities.most_layers == goldfeather::kAllLayers;
        (finds_all ? all : first) += std::string(each.name) + ", ";
    }
    std::sort(names.begin(), names.end());
    table.add({"--engine", fmt::format("{}or {}of which the first layer is compared ({})", all, first, o.engine->name)},
              engine, names);
    table.add({"--views", "Views spread over the sphere, of both projections in turn (1)"}, o.views, 1, 100);
    table.add({"--camera", "One view instead: the numbers of csgscope --camera"}, camera);
    table.add({"--projection", "Of --camera: o (orthographic) or p (perspective, default)"}, projection, {"o", "p"});
    table.add({"--imgsize", "Width and height in pixels (256,256); of one number both"}, size);
    table.add({"--parts", "Of versions: what is a part, as in csgscope --help (top)"}, parts);
    table.add_flag({"--json", "Print JSON instead of a table"}, o.json);
    table.add({"--report", "Folder for report.html, report.json and pictures of the differences"}, o.report);
    table.add({"--tolerance", "Largest share of wrong pixels outside the band (0)"}, o.tolerance, 0.0, 1.0);
    table.add({"--reference", "A picture to compare with, as --against FILE.png"}, o.reference);
    table.add({"--reference-threshold", "Largest share of pixels that may differ (0.01)"}, o.reference_threshold, 0.0,
              1.0);
    table.add_positive({"--time-limit", "End with an error after so many seconds"}, o.time_limit, 1e9);
    try {
        if (!table.read(arguments)) {
            write_output("-", table.help());
            o.input.clear();
            return o;
        }
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("compare: {}", error.what()));
    }
    o.engine = engines.at(engine);
    if (o.against.ends_with(".png")) {
        o.reference = o.against;
    }
    if (!parts.empty()) {
        if (o.later.empty()) {
            throw UsageError("compare: --parts divides versions, OLD.scad NEW.scad");
        }
        o.parts = read_parts(parts);
    }
    if (!size.empty()) {
        constexpr int kLeast = 16, kMost = 4096;
        o.size = read_size(size, {1, 2}, kLeast, kMost);
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
