// Operands and operations of a model that change nothing, or leave nothing.
#pragma once

#include <stop_token>
#include <vector>

#include "ui/pipeline/inspection/effects.h"
#include "ui/pipeline/inspection/findings.h"
#include "ui/pipeline/inspection/solid_probe.h"
#include "ui/pipeline/model.h"

namespace ui {

/// `effects`: what is known of samples. Where an operand seems to do nothing it is looked at more closely first, at
/// samples so near to each other that some thousands lie where it could do something. Of an operation within another
/// that does nothing, only the outer one is told.
[[nodiscard]] std::vector<Finding> idle_operands(const Model& model, const SolidProbe& probe,
                                                 const ExpressionLinks& links, Effects effects, const csg::Box& box,
                                                 const std::stop_token& stop);

}  // namespace ui
