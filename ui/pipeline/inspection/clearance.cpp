#include "ui/pipeline/inspection/clearance.h"

#include <algorithm>
#include <limits>

#include "base/stop.h"

namespace ui {

namespace {

struct Piece {
    Corners corners;
    csg::LeafId leaf;
    std::uint32_t triangle;
};

std::vector<Piece> triangles_of(const SolidProbe& probe, std::span<const csg::PartId> parts) {
    std::vector<Piece> pieces;
    for (const csg::PartId id : parts) {
        const csg::Part& part = probe.scene().parts[id];
        for (csg::LeafId leaf = part.first_leaf; leaf < part.first_leaf + part.leaf_count; ++leaf) {
            const csg::solid::PlacedLeaf& placed = probe.geometry().leaves[leaf];
            for (std::uint32_t i = 0; i < placed.triangles.size(); ++i) {
                const glm::uvec3& t = placed.triangles[i];
                pieces.push_back({{placed.points[t.x], placed.points[t.y], placed.points[t.z]}, leaf, i});
            }
        }
    }
    return pieces;
}

csg::Box box_of(const Piece& piece, double wider) {
    csg::Box box;
    for (const glm::dvec3& corner : piece.corners) {
        box = csg::enclose(box, corner);
    }
    return {box.lo - wider, box.hi + wider};
}

class ClearanceSearch {
  public:
    ClearanceSearch(const SolidProbe& probe, const ExpressionLinks& links, std::span<const csg::PartId> a,
                    std::span<const csg::PartId> b, double most, double least_piece)
        : probe_(probe), ray_(probe, links), a_(a), b_(b), best_{most, 0, {}, {}, 0, 0}, least_piece_(least_piece) {}

    void look(const Piece& a, const Piece& b) {
        const Nearest nearest = nearest_points(a.corners, b.corners);
        if (nearest.distance >= best_.distance) {
            return;
        }
        if (is_face(a, nearest.a, a_) && is_face(b, nearest.b, b_)) {
            best_ = {nearest.distance, 0.0, nearest.a, nearest.b, a.leaf, b.leaf};
            found_ = true;
            return;
        }
        constexpr int kMostHalvings = 2'000'000;
        const double size_a = longest(a.corners).second, size_b = longest(b.corners).second;
        if (std::max(size_a, size_b) <= least_piece_ || ++halvings_ > kMostHalvings) {
            left_ = std::min(left_, nearest.distance);
            return;
        }
        const bool halve_a = size_a >= size_b;
        Piece halves[2]{halve_a ? a : b, halve_a ? a : b};
        halve(halves[0], halves[1]);
        double distances[2];
        for (int i = 0; i < 2; ++i) {
            distances[i] = nearest_points(halves[i].corners, (halve_a ? b : a).corners).distance;
        }
        const int first = distances[1] < distances[0] ? 1 : 0;
        for (const int i : {first, 1 - first}) {
            halve_a ? look(halves[i], b) : look(a, halves[i]);
        }
    }

    [[nodiscard]] std::optional<PartDistance> found() const {
        if (!found_) {
            return std::nullopt;
        }
        PartDistance best = best_;
        best.error = std::max(probe_.event(), best.distance - left_);
        return best;
    }
    [[nodiscard]] double best() const { return best_.distance; }

  private:
    /// The first corner of the longest side, and its length.
    static std::pair<std::size_t, double> longest(const Corners& corners) {
        std::pair<std::size_t, double> result{0, 0};
        for (std::size_t i = 0; i < 3; ++i) {
            const double length = glm::length(corners[(i + 1) % 3] - corners[i]);
            result = length > result.second ? std::pair(i, length) : result;
        }
        return result;
    }

    static void halve(Piece& one, Piece& other) {
        const std::size_t i = longest(one.corners).first;
        const glm::dvec3 middle = 0.5 * (one.corners[i] + one.corners[(i + 1) % 3]);
        one.corners[(i + 1) % 3] = middle;
        other.corners[i] = middle;
    }

    /// Is the piece beside the point a face of one of the parts? On edges it is looked at a little towards the middle.
    bool is_face(const Piece& piece, const glm::dvec3& point, std::span<const csg::PartId> parts) {
        constexpr double kTowards = 1e-5;
        const glm::dvec3 middle = (piece.corners[0] + piece.corners[1] + piece.corners[2]) / 3.0;
        probe_.sides(point + kTowards * (middle - point), probe_.normal(piece.leaf, piece.triangle), sides_);
        const std::vector<csg::PartId> front = ray_.at(sides_.front).parts();
        const std::vector<csg::PartId>& behind = ray_.at(sides_.behind).parts();
        const auto holds = [](const auto& all, csg::PartId part) {
            return std::binary_search(all.begin(), all.end(), part);
        };
        return std::any_of(parts.begin(), parts.end(),
                           [&](csg::PartId part) { return holds(front, part) != holds(behind, part); });
    }

    const SolidProbe& probe_;
    PartRay ray_;
    SolidProbe::Sides sides_;
    std::span<const csg::PartId> a_, b_;
    PartDistance best_;
    double least_piece_;
    bool found_ = false;
    int halvings_ = 0;
    double left_ = std::numeric_limits<double>::infinity();  ///< The least of pieces that were left as they are.
};

}  // namespace

std::optional<PartDistance> distance_between(const SolidProbe& probe, const ExpressionLinks& links,
                                             std::span<const csg::PartId> a, std::span<const csg::PartId> b,
                                             double most, double least_piece, const std::stop_token& stop) {
    const std::vector<Piece> ours = triangles_of(probe, a), theirs = triangles_of(probe, b);
    std::vector<csg::Box> boxes;
    boxes.reserve(theirs.size());
    for (const Piece& piece : theirs) {
        boxes.push_back(box_of(piece, probe.event()));
    }
    const csg::reference::BoxTree tree(boxes);
    ClearanceSearch search(probe, links, a, b, most, least_piece);
    for (const Piece& piece : ours) {
        base::end_if_asked(stop);
        tree.meeting(box_of(piece, search.best()), [&](std::uint32_t i) { search.look(piece, theirs[i]); });
    }
    return search.found();
}

}  // namespace ui
