// What the panel of inspections asks for.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "csg/tree/part_rule.h"
#include "ui/pipeline/inspection/findings.h"
#include "ui/pipeline/picture/thickness_request.h"
#include "ui/viewer/revision.h"

namespace ui {

/// Surfaces have the tones of their thickness; nothing: their colors.
struct SetThickness {
    std::optional<ThicknessRequest> thickness;
};
/// Shows what has changed since; nothing: the model.
struct CompareWith {
    std::optional<Baseline> before;
};
struct RunChecks {
    CheckRequest request;
    csg::PartRule parts;
};
struct RunMeasures {
    csg::PartRule parts;
    double precision = 0.01;  ///< See measure_by_layers.
};
/// How each part has changed since the baseline.
struct RunPartChanges {
    csg::PartRule parts;
};
struct CancelInspection {};
/// Goes to a finding of the last check, or to a thin place of the picture.
struct ShowFinding {
    std::size_t index = 0;
};
struct ShowThinPlace {
    std::size_t index = 0;
};
struct CopyText {
    std::string text;
};

using InspectionCommand = std::variant<SetThickness, CompareWith, RunChecks, RunMeasures, RunPartChanges,
                                       CancelInspection, ShowFinding, ShowThinPlace, CopyText>;

}  // namespace ui
