// Where the edges of a mesh pass a plane. Internal to csg/solid.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

namespace csg::solid {

class EdgeCrossings {
  public:
    /// `depths`: of the points that there are, behind the plane. New points are added behind them; the vector must
    /// outlive this.
    EdgeCrossings(std::vector<glm::dvec3>& points, std::vector<double> depths)
        : points_(points), depths_(std::move(depths)) {}

    /// Is a point that was there before the cut behind the plane, or in it?
    [[nodiscard]] bool inside(std::uint32_t point) const { return depths_[point] >= 0; }

    /// The point where an edge leaves: one for both faces that share the edge.
    [[nodiscard]] std::uint32_t crossing(std::uint32_t in, std::uint32_t out) {
        if (depths_[in] == 0) {
            return in;
        }
        const auto [at, is_new] = crossings_.try_emplace({in, out}, static_cast<std::uint32_t>(points_.size()));
        if (is_new) {
            const glm::dvec3 p = points_[in], q = points_[out];
            points_.push_back(p + (q - p) * (depths_[in] / (depths_[in] - depths_[out])));
        }
        return at->second;
    }

  private:
    std::vector<glm::dvec3>& points_;
    std::vector<double> depths_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
};

}  // namespace csg::solid
