// The options of csgscope compare.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/camera.h"
#include "csg/tree/part_rule.h"
#include "goldfeather/choice.h"
#include "ui/pipeline/program_runner.h"

namespace ui {

struct CompareOptions {
    std::string input;             ///< Empty: help was asked for, and printed.
    std::string later;             ///< A later version, which `input` is compared with; empty: none.
    std::string against = "cgal";  ///< Or "openscad", or a file.
    const goldfeather::EngineInfo* engine = &goldfeather::fallback_engine();
    std::string report;                  ///< Folder; empty: none.
    std::string reference;               ///< A picture; empty: meshes are compared.
    std::optional<base::Camera> camera;  ///< The only view; absent: `views` of them.
    double tolerance = 0, reference_threshold = 0.01;
    int views = 1;
    glm::ivec2 size{256};
    csg::PartRule parts{csg::PartRule::Kind::Depth, 1, {}};  ///< Of versions.
    bool json = false;                                       ///< Printed, instead of a text for people.
    double time_limit = 0;                                   ///< Seconds; 0: none.
    std::stop_token stop{};                                  ///< Where it is asked for, base::Stopped is thrown.
    std::shared_ptr<ProgramRunner> runner;                   ///< Of the input.
};

/// Throws UsageError.
[[nodiscard]] CompareOptions read_compare_options(const std::vector<std::string>& arguments);

}  // namespace ui
