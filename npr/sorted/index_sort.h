// Sorting that begins with the last frame's order (Learn WebGL 11.4: an index sort by insertion).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace npr {

/// What a sort took, in swaps of neighbors.
struct SortCount {
    std::uint64_t swaps = 0;         ///< From the order of the last sort.
    std::uint64_t from_nothing = 0;  ///< From the order in which things are given: what insertion would take then.
};

/// Indexes of things by their keys, the largest first; of equal ones the one given first.
class IndexSort {
  public:
    /// Keys of as many things as last time, or a new beginning.
    SortCount sort(std::span<const double> keys);
    [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

  private:
    std::vector<std::uint32_t> order_;
};

/// How many swaps of neighbors an insertion sort takes: pairs that stand the wrong way round.
[[nodiscard]] std::uint64_t inversions(std::vector<std::uint32_t> order, std::span<const double> keys);

}  // namespace npr
