#include "ui/command_line/run_checks.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "npr/style.h"

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
    if (!(options.depictions.empty() && options.depiction_rules.empty()) && needs_geometry(options)) {
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

std::string ignored_transparency(const npr::Picture& picture) {
    if (picture.transparency == npr::Transparency::Exact || npr::follows_transparency(*picture.style) ||
        std::any_of(picture.part_styles.begin(), picture.part_styles.end(),
                    [](const npr::PartStyle& part) { return npr::follows_transparency(*part.style); })) {
        return {};
    }
    std::vector<std::string_view> followers;
    for (const npr::StyleInfo& style : npr::styles()) {
        if (npr::follows_transparency(style)) {
            followers.push_back(style.name);
        }
    }
    const auto models = npr::transparencies();
    const auto model = std::find_if(models.begin(), models.end(), [&](const npr::TransparencyInfo& each) {
        return each.model == picture.transparency;
    });
    return fmt::format(
        "--transparency {} changes nothing: style {} has its own way to look inside, or none; {} follow it",
        model->name, picture.style->name, fmt::join(followers, ", "));
}

}  // namespace ui
