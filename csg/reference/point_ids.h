// Points by their coordinates, to the last bit.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <tuple>
#include <utility>

namespace csg::reference {

/// Numbers points from 0 in the order in which they come; zeros of either sign are equal. Where points within a
/// tolerance are one, there is PointTable.
class PointIds {
  public:
    /// The point's number, and whether it is new.
    std::pair<std::uint32_t, bool> add(const glm::dvec3& p) {
        const auto [at, added] =
            ids_.try_emplace({p.x + 0.0, p.y + 0.0, p.z + 0.0}, static_cast<std::uint32_t>(ids_.size()));
        return {at->second, added};
    }

  private:
    std::map<std::tuple<double, double, double>, std::uint32_t> ids_;
};

}  // namespace csg::reference
