// Which few of many numbers are to change.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace ui {

/// Changes x, of as few of the columns as do, with sum x_i columns_i = r but for a thousandth: pairs of a column and
/// its change. Of equally few those with which the numbers, `values` + x, have the shortest decimals, `tolerance` of
/// the numbers being of no matter; then the smallest changes. Nothing where r is not to be reached.
[[nodiscard]] std::optional<std::vector<std::pair<std::size_t, double>>> sparse_step(
    const std::vector<glm::dvec3>& columns, const glm::dvec3& r, const std::vector<double>& values, double tolerance);

}  // namespace ui
