// What is inside a leaf: winding numbers, or evenness where a leaf's surface is not one (DESIGN, section 3, rule 6).
#pragma once

#include <cstdint>
#include <vector>

#include "csg/reference/leaf_group.h"

namespace csg::reference {

/// How often the faces of a leaf cover a place, or wind around it; never 0.
struct Cover {
    LeafId leaf = 0;
    std::int32_t count = 0;
    bool operator==(const Cover&) const = default;
};
using Covers = std::vector<Cover>;  ///< Sorted by leaf.

class InsideRule {
  public:
    explicit InsideRule(const LeafGroup& group);
    /// Of one closed leaf, number 0.
    InsideRule() : even_odd_{0} {}

    /// The count itself for a closed leaf, 0 or 1 for any other.
    [[nodiscard]] std::int32_t reduced(LeafId leaf, std::int32_t count) const {
        return even_odd_[leaf] != 0 ? count & 1 : count;
    }
    /// a + sign · b, reduced.
    [[nodiscard]] Covers sum(const Covers& a, const Covers& b, std::int32_t sign) const;

  private:
    std::vector<char> even_odd_;  ///< By leaf.
};

}  // namespace csg::reference
