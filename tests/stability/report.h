// What a sweep found, as text, JSON, pictures and the tables of docs/ROBUSTNESS.md.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/stability/sweep.h"

namespace stability {

struct FamilyResult {
    Family family;
    std::vector<Measure> measures;
};

[[nodiscard]] nlohmann::ordered_json to_json(const std::vector<FamilyResult>& results);

/// Wrong pixels in percent against the difficulty, a line an engine, the worse of both projections.
[[nodiscard]] std::string to_svg(const FamilyResult& result);

/// The file name of a family's plot.
[[nodiscard]] std::string plot_name(const Family& family);

/// The summary table, and a section a family with its plot (in the folder `plots`).
[[nodiscard]] std::string to_markdown(const std::vector<FamilyResult>& results, const std::string& plots);

/// A line for every picture in which one of our engines has a wrong pixel.
[[nodiscard]] std::vector<std::string> wrong_pictures(const std::vector<FamilyResult>& results);

}  // namespace stability
