// Looks for faults of a model in its faces: thin walls, narrow gaps, parts that run into each other, operations that do
// nothing. No boolean mesh is made: faces of leaves are sampled, and rays run from there through the expression.
#pragma once

#include <stop_token>

#include "ui/pipeline/inspection/findings.h"
#include "ui/pipeline/model.h"

namespace ui {

/// Throws ModelError where a clearance names a part that there is not, and base::Stopped. Parts that are `%` or `#` do
/// not count. The same model gives the same findings, whatever the number of threads.
[[nodiscard]] CheckResult check(const Model& model, const CheckRequest& request, const std::stop_token& stop = {});

}  // namespace ui
