#include "ui/command_line/summary_parts.h"

#include <algorithm>

#include <fmt/format.h>

#include "ui/command_line/options.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

SummaryParts read_summary_parts(const std::vector<std::string>& names) {
    const std::vector<std::string> known{"all",          "cache", "time",   "camera", "geometry",
                                         "bounding-box", "area",  "volume", "parts",  "measures"};
    SummaryParts parts;
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            throw UsageError(
                fmt::format("--summary {}: expected {}.{}", name, fmt::join(known, ", "), suggestion(name, known)));
        }
        parts.all |= name == "all";
        parts.cache |= name == "cache";
        parts.time |= name == "time";
        parts.camera |= name == "camera";
        parts.geometry |= name == "geometry";
        parts.bounding_box |= name == "bounding-box";
        parts.area |= name == "area";
        parts.volume |= name == "volume";
        parts.parts |= name == "parts";
        parts.measures |= name == "measures";
    }
    return parts.all || names.empty()
               ? SummaryParts{true, true, true, true, true, true, true, true, parts.parts, parts.measures}
               : parts;
}

}  // namespace ui
