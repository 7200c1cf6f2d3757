#include "ui/command_line/run_checks.h"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ui {

void check_combinations(const Options& options, const npr::Picture& picture) {
    std::vector<std::string> to_standard_output;
    for (const Output& output : options.outputs) {
        if (output.path == "-") {
            to_standard_output.emplace_back("-o");
        }
    }
    for (const auto& [name, path] :
         {std::pair("--stats", options.statistics), std::pair("--summary-file", options.summary_file)}) {
        if (path == "-") {
            to_standard_output.emplace_back(name);
        }
    }
    if (to_standard_output.size() > 1) {
        throw UsageError(fmt::format("only one of {} can go to standard output", fmt::join(to_standard_output, ", ")));
    }
    if (!options.changes_from.empty() && needs_geometry(options)) {
        throw UsageError("--changes-from is of pictures; csgscope compare OLD NEW tells the volumes");
    }
    if (!(options.explain.empty() && options.without.empty()) && needs_geometry(options)) {
        throw UsageError("--explain and --without are of pictures; a mesh is what the file says");
    }
    if (!options.depictions.empty() && needs_geometry(options)) {
        throw UsageError("--depict is of pictures; a mesh is what the file says");
    }
    const int instead =
        (options.explain.empty() ? 0 : 1) + (options.without.empty() ? 0 : 1) + (options.changes_from.empty() ? 0 : 1);
    if (instead > 1) {
        throw UsageError("--explain, --without and --changes-from are pictures of different models; draw one");
    }
    if (!picture.sections.cuts.empty() && needs_geometry(options)) {
        throw UsageError("--section is of pictures; in a mesh or a drawing, cut with difference() in the file");
    }
}

}  // namespace ui
