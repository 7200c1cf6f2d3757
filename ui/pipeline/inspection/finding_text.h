// Findings of a check, in words.
#pragma once

#include <string>

#include "ui/pipeline/inspection/findings.h"
#include "ui/pipeline/model.h"

namespace ui {

[[nodiscard]] const FindingKindInfo& info(FindingKind kind);

/// "thin wall, 0.4 mm (the worst may be 0.01 less), limit 0.8"; of a finding in the model.
[[nodiscard]] std::string headline(const Model& model, const Finding& finding);

/// "[0, 2.5, 4]", in six digits.
[[nodiscard]] std::string point_text(const glm::dvec3& point);

}  // namespace ui
