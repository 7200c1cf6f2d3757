#include "ui/command_line/check_options.h"

#include <fmt/format.h>

#include "ui/command_line/option_table.h"
#include "ui/command_line/option_values.h"
#include "ui/command_line/subcommand.h"

namespace ui {

namespace {

constexpr double kUnset = -1, kLargest = 1e9;

/// Numbers where -1 stands for none, and texts, as they are given.
struct RawCheck {
    double min_wall = kUnset, min_gap = kUnset, min_feature = kUnset, max_overhang = kUnset, min_volume = kUnset,
           max_volume = kUnset, spacing = kUnset, time_limit = kUnset;
    std::string interference, max_size, parts, format = "text";
    std::vector<std::string> clearances;
};

void declare_check(OptionTable& table, CheckOptions& o, RawCheck& raw) {
    const char* const what = "What to look for, in mm";
    table.add({"file", "The .scad file; - reads standard input"}, o.run.input, true);
    const auto length = [&](const char* name, double& value, const char* text) {
        table.add_positive({name, text, "MM", what}, value, kLargest);
    };
    length("--min-wall", raw.min_wall, "Walls thinner than that");
    length("--min-gap", raw.min_gap, "Gaps narrower than that, in a part or between parts");
    length("--min-feature", raw.min_feature, "Pins and holes less than that across");
    table.add_flag({"--interference", "Parts that share a volume, more than MM deep (=0)", "", what}, raw.interference);
    table.add_each({"--clearance", "Parts A and B nearer to each other than that; may be repeated", "A,B=MM", what},
                   raw.clearances);
    table.add_flag({"--no-effect",
                    "Subtractions that cut nothing, intersections that leave nothing, parts wholly inside others, "
                    "solids that are there twice",
                    "", what},
                   o.request.no_effect);
    table.add_flag({"--coincident", "Faces that only touch, or end just in each other", "", what},
                   o.request.coincident);
    table.add({"--max-overhang", "Faces that look down by more degrees from upright, but on the bed", "DEGREES", what},
              raw.max_overhang, 0.0, 90.0);
    table.add({"--max-size", "A model larger than that along an axis", "X,Y,Z", what}, raw.max_size);
    table.add({"--min-volume", "A volume below that", "MM3", what}, raw.min_volume, 0.0, 1e18);
    table.add({"--max-volume", "A volume above that", "MM3", what}, raw.max_volume, 0.0, 1e18);
    table.add_positive({"--spacing", "Of samples on faces, at most (by the model's size)", "MM", what}, raw.spacing,
                       kLargest);
    const char* const tell = "How to tell it";
    table.add({"--format", "text, json, sarif or junit (text)", "FORMAT", tell}, raw.format,
              {"text", "json", "sarif", "junit"});
    table.add({"-o,--o", "Write to FILE instead of standard output", "FILE", tell}, o.output);
    table.add({"--report", "Folder for report.html, with a picture of each finding, and report.json", "DIR", tell},
              o.report);
    const char* const model = "The model";
    table.add({"--parts", "What is a part, as in csgscope --help (model; with --interference or --clearance top)",
               "RULE", model},
              raw.parts);
    declare_model(table, o.run, raw.time_limit, model);
    table.add_flag({"-q,--quiet", "Print errors and findings only", "", model}, o.run.quiet);
}

Clearance read_clearance(const std::string& text) {
    const std::size_t equals = text.rfind('=');
    const std::vector<std::string> names = names_of(text.substr(0, equals));
    if (equals == std::string::npos || names.size() != 2) {
        throw UsageError(fmt::format("--clearance {}: expected A,B=MM", text));
    }
    const double least = read_numbers(fmt::format("--clearance {}", text.substr(0, equals)), text.substr(equals + 1),
                                      {1}, "a length")[0];
    if (least <= 0) {
        throw UsageError(fmt::format("--clearance {}: the length is above 0", text));
    }
    return {names[0], names[1], least};
}

void interpret(CheckOptions& o, const RawCheck& raw) {
    const auto given = [](double value) { return value == kUnset ? std::nullopt : std::optional(value); };
    o.request.min_wall = given(raw.min_wall);
    o.request.min_gap = given(raw.min_gap);
    o.request.min_feature = given(raw.min_feature);
    o.request.max_overhang = given(raw.max_overhang);
    o.request.min_volume = given(raw.min_volume);
    o.request.max_volume = given(raw.max_volume);
    o.request.spacing = given(raw.spacing).value_or(0);
    o.run.time_limit = given(raw.time_limit).value_or(0);
    if (!raw.interference.empty()) {
        const double depth =
            raw.interference == "true" ? 0 : read_numbers("--interference", raw.interference, {1}, "a depth")[0];
        if (depth < 0) {
            throw UsageError(fmt::format("--interference {}: a depth is 0 or more", raw.interference));
        }
        o.request.interference = depth;
    }
    for (const std::string& text : raw.clearances) {
        o.request.clearances.push_back(read_clearance(text));
    }
    if (!raw.max_size.empty()) {
        const auto n = read_numbers("--max-size", raw.max_size, {3}, "x,y,z");
        o.request.max_size = {n[0], n[1], n[2]};
    }
    const CheckRequest& r = o.request;
    if (!(r.min_wall || r.min_gap || r.min_feature || r.interference || !r.clearances.empty() || r.no_effect ||
          r.coincident || r.max_overhang || r.max_size || r.min_volume || r.max_volume)) {
        throw UsageError("there is nothing to look for; see csgscope check --help");
    }
    const bool between_parts = r.interference || !r.clearances.empty();
    o.run.parts = !raw.parts.empty() ? read_parts(raw.parts) : read_parts(between_parts ? "top" : "model");
    o.format = read_name<CheckFormat>("--format", raw.format,
                                      {{"text", CheckFormat::Text},
                                       {"json", CheckFormat::Json},
                                       {"sarif", CheckFormat::Sarif},
                                       {"junit", CheckFormat::Junit}});
}

}  // namespace

CheckOptions read_check_options(const std::vector<std::string>& arguments) {
    CheckOptions o;
    RawCheck raw;
    o.run.preview = false;
    OptionTable table(
        "csgscope check looks for faults of a model: thin walls, narrow gaps, parts that run into each other, "
        "operations that do nothing.\nIt ends with 0 where there are none, with 1 where there are, and with 2 where "
        "the "
        "input is bad.",
        "csgscope check");
    table.lay_out_help("How to tell it", 34);
    declare_check(table, o, raw);
    o.help = !read_subcommand(table, arguments, "check", [&] { interpret(o, raw); });
    return o;
}

}  // namespace ui
