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

    /// Of the numbers.
    [[nodiscard]] std::size_t size() const { return parent_.size(); }

    /// The number that stands for the set of `i`.
    [[nodiscard]] std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) {
            i = parent_[i] = parent_[parent_[i]];
        }
        return i;
    }
    /// Makes one set of two; that of `b` stands for it.
    void unite(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

  private:
    std::vector<std::uint32_t> parent_;
};

/// Numbers sets from 0, in the order in which they are first asked for.
class SetNumbers {
  public:
    /// Keeps the reference; nothing may be united any more.
    explicit SetNumbers(DisjointSets& sets) : sets_(sets), numbers_(sets.size(), kNone) {}

    /// That of the set of `i`.
    std::uint32_t operator()(std::uint32_t i) {
        std::uint32_t& number = numbers_[sets_.find(i)];
        if (number == kNone) {
            number = count_++;
        }
        return number;
    }
    /// How many sets have been asked for.
    [[nodiscard]] std::uint32_t count() const { return count_; }

  private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    DisjointSets& sets_;
    std::vector<std::uint32_t> numbers_;  ///< By what stands for the set.
    std::uint32_t count_ = 0;
};

}  // namespace csg::reference
