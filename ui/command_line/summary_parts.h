// What --summary is asked to tell.
#pragma once

#include <string>
#include <vector>

namespace ui {

/// What is told.
struct SummaryParts {
    bool cache = false, time = false, camera = false, geometry = false, bounding_box = false, area = false,
         volume = false;
    bool all = false;                      ///< Said as such, or nothing was said.
    bool parts = false, measures = false;  ///< Told only where they are named.

    /// Is the mesh (or the region) asked for by name? `all` takes it where it was made anyway.
    [[nodiscard]] bool needs_geometry() const { return !all && (geometry || area || volume); }
};

/// Of the values of --summary; everything where there are none. Throws UsageError.
[[nodiscard]] SummaryParts read_summary_parts(const std::vector<std::string>& names);

}  // namespace ui
