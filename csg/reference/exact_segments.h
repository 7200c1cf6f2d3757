// The segments in which faces end or meet, in exact arithmetic. For this library's own files: it includes CGAL.
#pragma once

#include <array>
#include <map>
#include <stop_token>
#include <unordered_map>
#include <vector>

#include "csg/reference/exact_faces.h"
#include "csg/reference/exact_points.h"
#include "csg/reference/winding.h"

namespace csg::reference {

/// A segment and the line it is on: through two corners of leaves, or where two planes meet.
struct ExactSegment {
    std::uint32_t from, to;             ///< Points; from < to.
    bool edge;                          ///< The line is through two corners; else that of two planes.
    std::array<std::uint32_t, 2> line;  /// Corners, or planes.
};

struct ExactBorder {
    std::uint32_t segment;
    LeafId leaf;
    std::int32_t count;  ///< How much more often its faces cover the left of the segment than the right.
};

struct ExactPlaneContent {
    std::vector<std::uint32_t> segments;  ///< Sorted, each once; those of the borders among them.
    std::vector<ExactBorder> borders;
};

/// The segments of all planes, in the end split wherever they cross, touch or overlap: alike in all planes they lie in.
class ExactSegments {
  public:
    /// Keeps `faces`. Throws base::Stopped.
    ExactSegments(const ExactFaces& faces, const InsideRule& rule, const std::stop_token& stop);

    [[nodiscard]] const ExactPoints& points() const { return points_; }
    /// By plane of the faces.
    [[nodiscard]] const std::vector<ExactPlaneContent>& planes() const { return planes_; }
    [[nodiscard]] const ExactSegment& operator[](std::uint32_t segment) const { return segments_[segment]; }
    /// All points on the segment, from one end to the other.
    [[nodiscard]] std::vector<std::uint32_t> chain(std::uint32_t segment) const;
    /// A point in the plane's picture.
    [[nodiscard]] ExactKernel::Point_2 picture(std::uint32_t plane, std::uint32_t point) const;

  private:
    friend class ExactSplitter;
    using PointKey = std::array<std::uint32_t, 5>;  // the kind first

    void add_borders(const InsideRule& rule);
    void meet(const ExactFace& a, const ExactFace& b);
    void add_meeting_points(const ExactFace& a, const ExactFace& b, std::vector<std::uint32_t>& found,
                            std::array<int, 3>& sides);
    std::uint32_t add_segment(std::uint32_t a, std::uint32_t b, bool edge, std::array<std::uint32_t, 2> line);
    /// The point of an edge's line in a plane.
    std::uint32_t point_on(std::array<std::uint32_t, 2> edge, std::uint32_t plane);
    /// The point where two segments of a plane cross.
    std::uint32_t crossing(const ExactSegment& s, const ExactSegment& t, std::uint32_t plane);
    void split(const std::stop_token& stop);
    void sort_lines();

    const ExactFaces& faces_;
    ExactPoints points_;
    std::vector<ExactSegment> segments_;
    std::unordered_map<std::uint64_t, std::uint32_t> by_ends_;
    std::vector<ExactPlaneContent> planes_;
    std::map<PointKey, std::uint32_t> known_;         ///< Points by what meets there.
    std::vector<std::vector<std::uint32_t>> splits_;  ///< By segment.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> overlaps_;
    std::vector<std::uint32_t> line_of_;             ///< By segment.
    std::vector<std::vector<std::uint32_t>> lines_;  ///< The points on each, in order.
};

}  // namespace csg::reference
