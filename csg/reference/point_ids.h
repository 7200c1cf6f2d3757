// Points by their coordinates, to the last bit.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <unordered_map>
#include <utility>

#include "csg/tree/hash.h"

namespace csg::reference {

/// Numbers points from 0 in the order in which they come; zeros of either sign are equal. Where points within a
/// tolerance are one, there is PointTable.
class PointIds {
  public:
    /// The point's number, and whether it is new.
    std::pair<std::uint32_t, bool> add(const glm::dvec3& p) {
        const auto [at, added] = ids_.try_emplace(p, static_cast<std::uint32_t>(ids_.size()));
        return {at->second, added};
    }

  private:
    struct Hash {
        std::size_t operator()(const glm::dvec3& p) const { return mix(0, p); }
    };
    std::unordered_map<glm::dvec3, std::uint32_t, Hash> ids_;
};

}  // namespace csg::reference
