// The segments in which the faces of a scene end or meet, plane by plane.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <unordered_map>
#include <vector>

#include "csg/reference/leaf_group.h"
#include "csg/reference/point_table.h"
#include "csg/reference/winding.h"

namespace csg::reference {

/// The scene is too near to degenerate for double precision: points and lines within the tolerance do not fit
/// together. Exact arithmetic must decide.
class Undecided : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Segments between points of a table, each once. A segment that lies in several planes is split in all of them where
/// it is split in one: so the planes' arrangements fit together.
class SegmentTable {
  public:
    struct Segment {
        std::uint32_t from = 0, to = 0;     ///< from < to
        std::vector<std::uint32_t> splits;  ///< Points on it, in any order, perhaps repeated.
    };

    std::uint32_t add(std::uint32_t a, std::uint32_t b);
    void split(std::uint32_t segment, std::uint32_t point) { segments_[segment].splits.push_back(point); }
    [[nodiscard]] const Segment& operator[](std::uint32_t id) const { return segments_[id]; }
    [[nodiscard]] std::size_t size() const { return segments_.size(); }
    /// All points of the segment, sorted from one end to the other.
    [[nodiscard]] std::vector<std::uint32_t> chain(std::uint32_t id, const PointTable& points) const;

  private:
    std::vector<Segment> segments_;
    std::unordered_map<std::uint64_t, std::uint32_t> by_ends_;
};

/// What lies in one plane.
struct PlaneContent {
    struct Border {
        std::uint32_t segment;
        LeafId leaf;
        std::int32_t count;  ///< How much more often its faces cover the left of the segment than the right.
    };
    std::uint32_t index = 0;  ///< Among the planes of the group.
    solid::Plane plane;
    std::vector<std::uint32_t> segments;  ///< Sorted, each once; those of the borders among them.
    std::vector<Border> borders;
};

struct Content {
    explicit Content(double tolerance) : points(tolerance) {}
    PointTable points;
    SegmentTable segments;
    std::vector<PlaneContent> planes;  ///< Those in which there are faces, in the order of their indices.
};

/// Collects the borders of the faces, and the segments in which faces of two leaves (or, of one that is not convex, of
/// its own) on different planes meet. Not yet split where they cross. Throws Undecided.
[[nodiscard]] Content collect_segments(const LeafGroup& group, const InsideRule& rule,
                                       const std::stop_token& stop = {});

/// Splits the segments of each plane where they cross or touch.
void split_segments(Content& content, const std::stop_token& stop = {});

}  // namespace csg::reference
