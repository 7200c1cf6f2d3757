// What csgscope check tells.
#pragma once

#include <string>

#include "csg/scad/scad.h"
#include "ui/pipeline/inspection/findings.h"
#include "ui/pipeline/json.h"
#include "ui/pipeline/model.h"

namespace ui {

struct CheckReport {
    const Model& model;
    const csg::scad::SourceSet& sources;  ///< Of the program that made the model.
    std::string input;                    ///< The file.
    const CheckRequest& request;
    const CheckResult& result;
};

/// For people: a paragraph for each finding, with the calls that made the faces.
[[nodiscard]] std::string check_text(const CheckReport& report);

[[nodiscard]] Json check_json(const CheckReport& report);

/// SARIF 2.1.0 (OASIS 2020): a result for each finding, at the innermost call of its face.
[[nodiscard]] Json check_sarif(const CheckReport& report);

/// JUnit's XML: a test case that fails for each finding, and one that does not for each kind that was looked for in
/// vain.
[[nodiscard]] std::string check_junit(const CheckReport& report);

}  // namespace ui
