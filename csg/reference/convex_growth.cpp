#include "csg/reference/convex_growth.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/stop.h"
#include "csg/reference/convex_cut.h"
#include "csg/reference/point_ids.h"
#include "csg/solid/plane_table.h"

namespace csg::reference {
namespace {

/// Of the faces that all points are behind: the plane of a thin face may be far off, and then is left out.
std::vector<solid::Plane> planes_of(const Convex& convex, double tolerance) {
    std::vector<solid::Plane> planes;
    for (const glm::uvec3& t : convex.triangles()) {
        const glm::dvec3 &a = convex.points()[t.x], &b = convex.points()[t.y], &c = convex.points()[t.z];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double length = glm::length(normal);
        if (!(length > 0)) {
            continue;
        }
        const solid::Plane plane{normal / length, glm::dot(normal, a) / length};
        if (std::all_of(convex.points().begin(), convex.points().end(), [&](const glm::dvec3& p) {
                return glm::dot(plane.normal, p) - plane.offset <= 0.5 * tolerance;
            })) {
            planes.push_back(plane);
        }
    }
    return planes;
}

Box box_of(std::span<const glm::dvec3> points) {
    Box box;
    for (const glm::dvec3& p : points) {
        box = enclose(box, p);
    }
    return box;
}

class Grower {
  public:
    Grower(std::vector<Convex> pieces, std::span<const std::vector<glm::dvec3>> facets, double tolerance,
           const std::function<bool(const glm::dvec3&)>& holds, const std::stop_token& stop)
        : facets_(facets), tolerance_(tolerance), holds_(holds), stop_(stop) {
        for (const auto& facet : facets) {
            boxes_.push_back(box_of(facet));
        }
        std::vector<std::vector<std::uint32_t>> at_point;
        PointIds ids;
        for (Convex& piece : pieces) {
            const auto own = static_cast<std::uint32_t>(patches_.size());
            for (const glm::dvec3& p : piece.points()) {
                const std::uint32_t id = ids.add(p).first;
                at_point.resize(std::max<std::size_t>(at_point.size(), id + 1));
                at_point[id].push_back(own);
            }
            patches_.push_back({std::move(piece), {}});
        }
        std::vector<std::pair<std::uint32_t, std::uint32_t>> shared;
        for (const auto& around : at_point) {
            for (const std::uint32_t a : around) {
                for (const std::uint32_t b : around) {
                    if (a < b && around.size() <= kCrowd) {
                        shared.emplace_back(a, b);
                    }
                }
            }
        }
        std::sort(shared.begin(), shared.end());
        for (std::size_t i = 1; i < shared.size(); ++i) {
            if (shared[i] == shared[i - 1]) {
                patches_[shared[i].first].neighbors.insert(shared[i].second);
                patches_[shared[i].second].neighbors.insert(shared[i].first);
            }
        }
    }

    std::vector<Convex> grow() {
        for (std::uint32_t i = 0; i < patches_.size(); ++i) {
            while (grow_one(i)) {
            }
        }
        std::vector<Convex> result;
        for (Patch& patch : patches_) {
            if (!patch.shape.empty()) {
                result.push_back(std::move(patch.shape));
            }
        }
        return result;
    }

  private:
    /// At a point where more pieces meet, they are not looked at as neighbors.
    static constexpr std::size_t kCrowd = 64;

    struct Patch {
        Convex shape;  ///< Empty once it is part of another.
        std::set<std::uint32_t> neighbors;
    };

    /// Takes in the first neighbor that it can.
    bool grow_one(std::uint32_t index) {
        if (patches_[index].shape.empty()) {
            return false;
        }
        for (const std::uint32_t other : patches_[index].neighbors) {
            base::end_if_asked(stop_);
            std::vector<glm::dvec3> points = patches_[index].shape.points();
            const std::vector<glm::dvec3>& more = patches_[other].shape.points();
            points.insert(points.end(), more.begin(), more.end());
            Convex both = Convex::hull_of(points, stop_);
            if (both.empty() || !within(both)) {
                continue;
            }
            patches_[index].shape = std::move(both);
            replace(other, index);
            return true;
        }
        return false;
    }

    void replace(std::uint32_t gone, std::uint32_t by) {
        for (const std::uint32_t n : patches_[gone].neighbors) {
            patches_[n].neighbors.erase(gone);
            if (n != by) {
                patches_[n].neighbors.insert(by);
                patches_[by].neighbors.insert(n);
            }
        }
        patches_[gone] = {};
    }

    [[nodiscard]] bool within(const Convex& shape) const {
        const std::vector<solid::Plane> planes = planes_of(shape, tolerance_);
        const Box box = box_of(shape.points());
        // The hull of what is flat but for rounding would be a skin that nothing cuts.
        const glm::dvec3 middle = shape.middle();
        if (std::any_of(planes.begin(), planes.end(), [&](const solid::Plane& plane) {
                return glm::dot(plane.normal, middle) - plane.offset > -8 * tolerance_;
            })) {
            return false;
        }
        for (std::size_t i = 0; i < facets_.size(); ++i) {
            if (!intersect(boxes_[i], box).empty() && cuts(facets_[i], planes, tolerance_)) {
                return false;
            }
        }
        return holds_(middle);
    }

    std::span<const std::vector<glm::dvec3>> facets_;
    double tolerance_;
    const std::function<bool(const glm::dvec3&)>& holds_;
    const std::stop_token& stop_;
    std::vector<Box> boxes_;
    std::vector<Patch> patches_;
};

}  // namespace

std::vector<Convex> grown(std::vector<Convex> pieces, std::span<const std::vector<glm::dvec3>> facets, double tolerance,
                          const std::function<bool(const glm::dvec3&)>& holds, const std::stop_token& stop) {
    return Grower(std::move(pieces), facets, tolerance, holds, stop).grow();
}

}  // namespace csg::reference
