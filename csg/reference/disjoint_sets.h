// Union-find: which of the first so many whole numbers belong together.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace csg::reference {

/// Each number is a set of its own at first. Paths are halved on the way (Tarjan and van Leeuwen 1984).
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    /// The number that stands for the set of `i`.
    [[nodiscard]] std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    /// Makes one set of two; that of `b` stands for it.
    void unite(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

  private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace csg::reference
