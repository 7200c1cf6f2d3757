// Rays through the leaves of a scene from any point in any direction, in double precision: no picture, no mesh.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "csg/reference/box_pairs.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"
#include "ui/pipeline/inspection/point_values.h"
#include "ui/pipeline/inspection/ray_tree.h"

namespace ui {

/// How often a leaf winds around a point; for leaves that are not closed, the parity of it counts.
struct Cover {
    csg::LeafId leaf = 0;
    int winding = 0;
};
using Covers = std::vector<Cover>;  ///< Those that are not zero, by leaf.

/// A place where a ray meets a leaf.
struct Crossing {
    double t = 0;  ///< World units along the ray, by the triangle's canonical plane.
    csg::LeafId leaf = 0;
    std::uint32_t triangle = 0;
    int step = 0;  ///< What passing it adds to the winding number.
};

/// Trees over the boxes of leaves and of their triangles; shared by all threads.
class SolidProbe {
  public:
    /// Both must outlive it.
    SolidProbe(const csg::Scene& scene, const csg::solid::Geometry& geometry);
    SolidProbe(const SolidProbe&) = delete;
    SolidProbe& operator=(const SolidProbe&) = delete;

    /// Two distances that differ by no more are the same.
    [[nodiscard]] double event() const { return event_; }
    [[nodiscard]] const csg::Scene& scene() const { return scene_; }
    [[nodiscard]] const csg::solid::Geometry& geometry() const { return geometry_; }

    /// The leaves about the points just before and just behind `point`, which may lie on faces: along `normal`, of
    /// length 1.
    struct Sides {
        Covers front, behind;
        std::vector<Crossing> met;  ///< Passed from behind to the front.
    };
    void sides(const glm::dvec3& point, const glm::dvec3& normal, Sides& out) const {
        sides(point, normal, std::nullopt, out);
    }
    /// The same for a point of a triangle, along its normal: a leaf of which no two shells overlap need not be asked
    /// what is on either side of its own faces.
    void sides_of(csg::LeafId leaf, std::uint32_t triangle, const glm::dvec3& point, Sides& out) const {
        sides(point, normal(leaf, triangle), std::pair(leaf, triangle), out);
    }

    /// The faces that a ray meets at more than event() and up to `most` from its origin, nearest first.
    void crossings(const glm::dvec3& origin, const glm::dvec3& direction, double most,
                   std::vector<Crossing>& out) const;

    /// A triangle of a leaf.
    struct Face {
        csg::LeafId leaf = 0;
        std::uint32_t triangle = 0;
    };
    /// For many rays of one direction from points of a box: all faces that they may meet and that `keep`(face) is true
    /// of. False where they are more than `most`; `out` holds some of them then.
    template <typename Keep>
    [[nodiscard]] bool faces_along(const csg::Box& origins, const glm::dvec3& direction, std::size_t most,
                                   const Keep& keep, std::vector<Face>& out) const {
        out.clear();
        leaf_rays_.along(origins, direction, std::numeric_limits<double>::infinity(), [&](std::uint32_t leaf) {
            triangles_[leaf].along(origins, direction, std::numeric_limits<double>::infinity(),
                                   [&](std::uint32_t triangle) {
                                       if (keep(Face{leaf, triangle})) {
                                           out.push_back({leaf, triangle});
                                       }
                                       return out.size() <= most;
                                   });
            return out.size() <= most;
        });
        return out.size() <= most;
    }
    /// As crossings(), of these faces alone.
    void crossings(const glm::dvec3& origin, const glm::dvec3& direction, std::span<const Face> faces,
                   std::vector<Crossing>& out) const;

    /// Outwards of the leaf, of length 1.
    [[nodiscard]] glm::dvec3 normal(csg::LeafId leaf, std::uint32_t triangle) const;
    [[nodiscard]] bool holds(const Cover& cover) const;
    /// Those that hold the point.
    void inside(const Covers& covers, std::vector<csg::LeafId>& out) const;

  private:
    void sides(const glm::dvec3& point, const glm::dvec3& normal,
               const std::optional<std::pair<csg::LeafId, std::uint32_t>>& own, Sides& out) const;
    /// From `least` to `most` along the ray.
    [[nodiscard]] std::optional<Crossing> crossing(csg::LeafId leaf, std::uint32_t triangle, const glm::dvec3& origin,
                                                   const glm::dvec3& direction, double least, double most) const;

    const csg::Scene& scene_;
    const csg::solid::Geometry& geometry_;
    double event_;
    std::vector<csg::Box> leaf_boxes_;
    csg::reference::BoxTree leaves_;
    RayTree leaf_rays_;
    std::vector<RayTree> triangles_;  ///< By leaf.
    std::vector<char> plain_;         ///< By leaf: it winds around no point but once, and its faces look outwards.
};

/// What a ray meets of the parts of a scene. One for each thread.
class PartRay {
  public:
    PartRay(const SolidProbe& probe, const ExpressionLinks& links) : probe_(probe), values_(links) {}

    struct Hit {
        double distance = 0;
        /// Between the ray and the face's normal: 1 where it is met head-on. Of several faces, of the most so.
        double cosine = 0;
        csg::LeafId leaf = 0;
        std::uint32_t triangle = 0;
        csg::PartId part = 0;
    };
    /// Where a ray from within `part`, whose origin `covers` hold, leaves it; nothing where it goes on for `most`.
    [[nodiscard]] std::optional<Hit> leave(csg::PartId part, const glm::dvec3& origin, const glm::dvec3& direction,
                                           const Covers& covers, double most);
    /// Where a ray from outside of all parts enters one.
    [[nodiscard]] std::optional<Hit> enter(const glm::dvec3& origin, const glm::dvec3& direction, const Covers& covers,
                                           double most);
    /// Where a ray from a point that is not in `part` enters it.
    [[nodiscard]] std::optional<Hit> enter(csg::PartId part, const glm::dvec3& origin, const glm::dvec3& direction,
                                           const Covers& covers, double most);
    /// Does a ray come through one of the `parts` (by part: 1 of those), farther than event() from its origin? It is
    /// followed from its far end, so that nobody need know what holds the origin.
    [[nodiscard]] bool passes(std::span<const char> parts, const glm::dvec3& origin, const glm::dvec3& direction);
    /// The same where it can meet these faces only.
    [[nodiscard]] bool passes(std::span<const char> parts, const glm::dvec3& origin, const glm::dvec3& direction,
                              std::span<const SolidProbe::Face> faces);
    /// Goes to the point that these hold.
    const PointValues& at(const Covers& covers);

  private:
    /// Of what crossings_ holds.
    [[nodiscard]] bool passes_one(std::span<const char> parts);
    template <typename Until>
    std::optional<Hit> walk(const glm::dvec3& origin, const glm::dvec3& direction, const Covers& covers, double most,
                            const Until& until);

    const SolidProbe& probe_;
    PointValues values_;
    std::vector<Crossing> crossings_;
    Covers covers_;
    std::vector<csg::LeafId> inside_;
};

}  // namespace ui
