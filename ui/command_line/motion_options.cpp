#include "ui/command_line/motion_options.h"

#include <fmt/format.h>

#include "ui/command_line/files.h"
#include "ui/command_line/option_table.h"
#include "ui/command_line/option_values.h"

namespace ui {

namespace {

constexpr double kUnset = -1, kLargest = 1e9;

struct RawMotion {
    std::string interval, format = "text";
    double error = kUnset, time_limit = kUnset;
};

void declare(OptionTable& table, MotionOptions& o, RawMotion& raw) {
    const char* const what = "What to look at";
    table.add({"file", "The .scad file; - reads standard input"}, o.run.input, true);
    table.add({"--interval", "Of $t (0,1)", "FROM,TO", what}, raw.interval);
    table.add_positive({"--error",
                        "Samples are as near to each other as it takes to know where everything is between "
                        "them, to within so much (1e-4 of the model's diagonal)",
                        "MM", what},
                       raw.error, kLargest);
    const char* const tell = "How to tell it";
    table.add({"--format", "text, or json with all samples, velocities and accelerations (text)", "FORMAT", tell},
              raw.format, {"text", "json"});
    table.add({"-o,--o", "Write to FILE instead of standard output", "FILE", tell}, o.output);
    const char* const model = "The model";
    table.add_each({"-D,--D", "Put a statement behind the file: -D 'size=[1,2]'", "STATEMENT", model},
                   o.run.definitions);
    table.add({"-p,--p", "A file of parameter sets", "FILE", model}, o.run.parameter_file);
    table.add({"-P,--P", "The parameter set of that file to take", "NAME", model}, o.run.parameter_set);
    table.add_positive({"--time-limit", "End with an error after so many seconds", "SECONDS", model}, raw.time_limit,
                       kLargest);
    table.add_flag({"--preview", "Evaluate with $preview true (false)", "", model}, o.run.preview);
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
    if (raw.error != kUnset) {
        o.request.error = raw.error;
    }
    o.json = raw.format == "json";
    o.request.derivatives = o.json;
    o.run.time_limit = raw.time_limit == kUnset ? 0 : raw.time_limit;
}

}  // namespace

MotionOptions read_motion_options(const std::vector<std::string>& arguments) {
    MotionOptions o;
    RawMotion raw;
    o.run.preview = false;
    OptionTable table("csgscope motion tells what of a model moves while $t runs: when, how, and how far.",
                      "csgscope motion");
    table.lay_out_help("How to tell it", 34);
    declare(table, o, raw);
    try {
        if (!table.read(arguments)) {
            write_output("-", table.help());
            o.help = true;
            return o;
        }
        table.refuse_empty_values();
        interpret(o, raw);
    } catch (const UnknownOption& unknown) {
        throw UsageError(fmt::format("motion: unknown option {}.{}", unknown.name(),
                                     suggestion(unknown.name(), table.long_names(), " See csgscope motion --help.")));
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("motion: {}", error.what()));
    }
    return o;
}

}  // namespace ui
