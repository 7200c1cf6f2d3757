// The findings of csgscope check as a page with pictures.
#pragma once

#include <stop_token>
#include <string>

#include "ui/command_line/check_report.h"

namespace ui {

/// One self-contained HTML page. Each finding has a picture with the place in its middle, the model cut open there
/// where a distance is to be seen; of more than a hundred, the first.
[[nodiscard]] std::string check_page(const CheckReport& report, const std::shared_ptr<const Model>& model,
                                     const std::stop_token& stop);

}  // namespace ui
