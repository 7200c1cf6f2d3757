#include "ui/command_line/motion_options.h"

#include <fmt/format.h>

#include "ui/command_line/option_table.h"
#include "ui/command_line/option_values.h"
#include "ui/command_line/subcommand.h"

namespace ui {

namespace {

constexpr double kUnsetMotion = -1, kLargestMotion = 1e9;

struct RawMotion {
    std::string interval, format = "text";
    double error = kUnsetMotion, time_limit = kUnsetMotion;
};

void declare_motion(OptionTable& table, MotionOptions& o, RawMotion& raw) {
    const char* const what = "What to look at";
    table.add({"file", "The .scad file; - reads standard input"}, o.run.input, true);
    table.add({"--interval", "Of $t (0,1)", "FROM,TO", what}, raw.interval);
    table.add_positive({"--error",
                        "Samples are as near to each other as it takes to know where everything is between "
                        "them, to within so much (1e-4 of the model's diagonal)",
                        "MM", what},
                       raw.error, kLargestMotion);
    const char* const tell = "How to tell it";
    table.add({"--format", "text, or json with all samples, velocities and accelerations (text)", "FORMAT", tell},
              raw.format, {"text", "json"});
    table.add({"-o,--o", "Write to FILE instead of standard output", "FILE", tell}, o.output);
    const char* const model = "The model";
    declare_model(table, o.run, raw.time_limit, model);
    table.add_flag({"-q,--quiet", "Print errors and the motion only", "", model}, o.run.quiet);
}

void interpret(MotionOptions& o, const RawMotion& raw) {
    if (!raw.interval.empty()) {
        const auto ends = read_numbers("--interval", raw.interval, {2}, "from,to");
        if (!(ends[0] < ends[1])) {
            throw UsageError(fmt::format("--interval {}: it ends before it begins", raw.interval));
        }
        o.request.from = ends[0];
        o.request.to = ends[1];
    }
    if (raw.error != kUnsetMotion) {
        o.request.error = raw.error;
    }
    o.json = raw.format == "json";
    o.request.derivatives = o.json;
    o.run.time_limit = raw.time_limit == kUnsetMotion ? 0 : raw.time_limit;
}

}  // namespace

MotionOptions read_motion_options(const std::vector<std::string>& arguments) {
    MotionOptions o;
    RawMotion raw;
    o.run.preview = false;
    OptionTable table("csgscope motion tells what of a model moves while $t runs: when, how, and how far.",
                      "csgscope motion");
    table.lay_out_help("How to tell it", 34);
    declare_motion(table, o, raw);
    o.help = !read_subcommand(table, arguments, "motion", [&] { interpret(o, raw); });
    return o;
}

}  // namespace ui
