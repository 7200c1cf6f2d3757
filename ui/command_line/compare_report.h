// The report of csgscope compare as one page for people.
#pragma once

#include <string>
#include <vector>

#include "base/image.h"
#include "ui/pipeline/json.h"

namespace ui {

/// One view: what was drawn, what should have been, and where they differ.
struct ComparedView {
    std::string title;
    base::Image drawn, expected, difference;
    Json all, outside;  ///< Errors of all pixels, and without the band.
};

/// One self-contained HTML page: each view side by side with a slider between the two, heat map and table.
[[nodiscard]] std::string report_page(const std::string& title, const std::string& summary,
                                      const std::vector<ComparedView>& views);

}  // namespace ui
