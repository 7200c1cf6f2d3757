// Limits of a model's box and volume.
#pragma once

#include <stop_token>
#include <vector>

#include "ui/pipeline/inspection/findings.h"
#include "ui/pipeline/model.h"

namespace ui {

/// What is larger or smaller than the request allows. A volume whose limit lies within what is not known of it is none.
[[nodiscard]] std::vector<Finding> size_findings(const Model& model, const CheckRequest& request,
                                                 const std::stop_token& stop);

}  // namespace ui
