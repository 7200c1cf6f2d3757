#include "csg/reference/exact_segments.h"

#include <algorithm>

#include "base/stop.h"
#include "csg/reference/disjoint_sets.h"
#include "csg/reference/edge_uses.h"
#include "csg/reference/exact_splitter.h"

namespace csg::reference {
namespace {

std::array<std::uint32_t, 2> sorted(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

}  // namespace

ExactSegments::ExactSegments(const ExactFaces& faces, const InsideRule& rule, const std::stop_token& stop)
    : faces_(faces), points_(faces.largest), planes_(faces.planes.size()) {
    // The corners first: a corner's number is that of its point.
    for (const glm::dvec3& corner : faces.corners.points()) {
        (void)points_.add(exact(corner));
    }
    add_borders(rule);
    for (const auto& [a, b] : faces.meeting) {
        base::end_if_asked(stop);
        meet(faces.faces[a], faces.faces[b]);
    }
    for (ExactPlaneContent& plane : planes_) {
        std::sort(plane.segments.begin(), plane.segments.end());
        plane.segments.erase(std::unique(plane.segments.begin(), plane.segments.end()), plane.segments.end());
    }
    split(stop);
    sort_lines();
}

void ExactSegments::add_borders(const InsideRule& rule) {
    std::vector<EdgeUse> uses;
    const std::vector<ExactFace>& faces = faces_.faces;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            uses.push_back(edge_use(faces[i].corners[k], faces[i].corners[(k + 1) % 3], faces[i].plane));
        }
        const LeafId leaf = faces[i].leaf;
        if (i + 1 < faces.size() && faces[i + 1].leaf == leaf) {
            continue;
        }
        visit_borders(uses, leaf, rule, [&](std::uint32_t lo, std::uint32_t hi, std::uint32_t at, std::int32_t count) {
            const std::uint32_t segment = add_segment(lo, hi, true, {lo, hi});
            planes_[at].segments.push_back(segment);
            if (count != 0) {
                planes_[at].borders.push_back({segment, leaf, count});
            }
        });
        uses.clear();
    }
}

std::uint32_t ExactSegments::add_segment(std::uint32_t a, std::uint32_t b, bool edge,
                                         std::array<std::uint32_t, 2> line) {
    const auto [from, to] = sorted(a, b);
    const auto [at, added] =
        by_ends_.try_emplace(std::uint64_t{from} << 32 | to, static_cast<std::uint32_t>(segments_.size()));
    if (added) {
        segments_.push_back({from, to, edge, line});
    }
    return at->second;
}

/// The corners of `b` in `a`, and the points where edges of `b` pass through `a`. `sides`: of b's corners.
void ExactSegments::add_meeting_points(const ExactFace& a, const ExactFace& b, std::vector<std::uint32_t>& found,
                                       std::array<int, 3>& sides) {
    for (std::size_t k = 0; k < 3; ++k) {
        sides[k] = side_of(faces_, a, b.corners[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t p = b.corners[k], q = b.corners[(k + 1) % 3];
        if (sides[k] == 0 && holds(faces_, a, p)) {
            found.push_back(p);
        }
        if (sides[k] * sides[(k + 1) % 3] < 0 && pierces(faces_, std::min(p, q), std::max(p, q), a)) {
            found.push_back(point_on(sorted(p, q), a.plane));
        }
    }
}

void ExactSegments::meet(const ExactFace& a, const ExactFace& b) {
    std::vector<std::uint32_t> found;
    std::array<int, 3> of_b{}, of_a{};
    add_meeting_points(a, b, found, of_b);
    add_meeting_points(b, a, found, of_a);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    if (found.size() < 2) {
        return;  // they touch in a point at most
    }
    const auto in_plane = [](const ExactFace& face, const std::array<int, 3>& sides) {
        std::vector<std::uint32_t> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            if (sides[k] == 0) {
                corners.push_back(face.corners[k]);
            }
        }
        return corners;
    };
    std::vector<std::uint32_t> edge = in_plane(a, of_a);
    if (edge.size() < 2) {
        edge = in_plane(b, of_b);
    }
    const std::uint32_t segment = edge.size() == 2 ? add_segment(found[0], found[1], true, sorted(edge[0], edge[1]))
                                                   : add_segment(found[0], found[1], false, sorted(a.plane, b.plane));
    planes_[a.plane].segments.push_back(segment);
    planes_[b.plane].segments.push_back(segment);
}

std::uint32_t ExactSegments::point_on(std::array<std::uint32_t, 2> edge, std::uint32_t plane) {
    const auto [at, added] = known_.try_emplace(PointKey{0, edge[0], edge[1], plane, 0});
    if (added) {
        const ExactFace& face = faces_.faces[faces_.planes[plane].face];
        at->second = points_.add(ExactKernel().construct_plane_line_intersection_point_3_object()(
            points_[face.corners[0]], points_[face.corners[1]], points_[face.corners[2]], points_[edge[0]],
            points_[edge[1]]));
    }
    return at->second;
}

std::uint32_t ExactSegments::crossing(const ExactSegment& s, const ExactSegment& t, std::uint32_t plane) {
    const auto other_plane = [&](const ExactSegment& of) { return of.line[0] == plane ? of.line[1] : of.line[0]; };
    if (s.edge && !t.edge) {
        return point_on(s.line, other_plane(t));
    }
    if (t.edge && !s.edge) {
        return point_on(t.line, other_plane(s));
    }
    if (s.edge) {
        const auto [first, second] = std::minmax(s.line, t.line);
        const auto [at, added] = known_.try_emplace(PointKey{2, first[0], first[1], second[0], second[1]});
        if (added) {
            // A plane through the one that is not the common one: any that is upright in the picture.
            const int up = 3 - faces_.planes[plane].u - faces_.planes[plane].v;
            glm::dvec3 aside = faces_.corners[t.line[0]];
            aside[up] += faces_.largest + 1;
            at->second = points_.add(ExactKernel().construct_plane_line_intersection_point_3_object()(
                points_[t.line[0]], points_[t.line[1]], exact(aside), points_[s.line[0]], points_[s.line[1]]));
        }
        return at->second;
    }
    std::array<std::uint32_t, 3> three{s.line[0], s.line[1], other_plane(t)};
    std::sort(three.begin(), three.end());
    const auto [at, added] = known_.try_emplace(PointKey{1, three[0], three[1], three[2], 0});
    if (added) {
        const auto through = [&](std::uint32_t of) {
            const ExactFace& face = faces_.faces[faces_.planes[of].face];
            return ExactKernel::Plane_3(points_[face.corners[0]], points_[face.corners[1]], points_[face.corners[2]]);
        };
        const auto found = CGAL::intersection(through(three[0]), through(three[1]), through(three[2]));
        at->second = points_.add(boost::get<ExactKernel::Point_3>(*found));
    }
    return at->second;
}

ExactKernel::Point_2 ExactSegments::picture(std::uint32_t plane, std::uint32_t point) const {
    const ExactKernel::Point_3& p = points_[point];
    const ExactPlane& axes = faces_.planes[plane];
    if (point < faces_.corners.points().size()) {
        const glm::dvec3& corner = faces_.corners[point];
        return {corner[axes.u], corner[axes.v]};
    }
    return {p[axes.u], p[axes.v]};
}

void ExactSegments::split(const std::stop_token& stop) {
    splits_.resize(segments_.size());
    for (std::uint32_t plane = 0; plane < planes_.size(); ++plane) {
        // Three segments that are all borders are those of one triangle. Faces that lie on each other and cancel have
        // no borders; what meets them may cross all the same.
        const ExactPlaneContent& content = planes_[plane];
        if (content.segments.size() > 3 || content.borders.size() < content.segments.size()) {
            ExactSplitter(*this, plane).split(stop);
        }
    }
}

/// Segments that overlap are on one line; what splits one of them there splits all.
void ExactSegments::sort_lines() {
    DisjointSets sets(segments_.size());
    for (const auto& [a, b] : overlaps_) {
        sets.unite(std::max(a, b), std::min(a, b));
    }
    constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> number(segments_.size(), kNone);
    line_of_.resize(segments_.size());
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
        std::uint32_t& n = number[sets.find(i)];
        if (n == kNone) {
            n = static_cast<std::uint32_t>(lines_.size());
            lines_.emplace_back();
        }
        line_of_[i] = n;
        std::vector<std::uint32_t>& line = lines_[n];
        line.insert(line.end(), {segments_[i].from, segments_[i].to});
        line.insert(line.end(), splits_[i].begin(), splits_[i].end());
    }
    for (std::vector<std::uint32_t>& line : lines_) {
        std::sort(line.begin(), line.end());
        line.erase(std::unique(line.begin(), line.end()), line.end());
        if (line.size() < 3) {
            continue;
        }
        const glm::dvec3 size = glm::abs(points_.near(line.back()) - points_.near(line.front()));
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        std::sort(line.begin(), line.end(), [&](std::uint32_t a, std::uint32_t b) {
            for (int i = 0; i < 3 && a != b; ++i) {
                const int k = (axis + i) % 3;
                if (const auto way = CGAL::compare(points_[a][k], points_[b][k]); way != CGAL::EQUAL) {
                    return way == CGAL::SMALLER;
                }
            }
            return false;
        });
    }
}

std::vector<std::uint32_t> ExactSegments::chain(std::uint32_t segment) const {
    const ExactSegment& s = segments_[segment];
    const std::vector<std::uint32_t>& line = lines_[line_of_[segment]];
    const auto from = std::find(line.begin(), line.end(), s.from), to = std::find(line.begin(), line.end(), s.to);
    std::vector<std::uint32_t> chain(std::min(from, to), std::max(from, to) + 1);
    if (to < from) {
        std::reverse(chain.begin(), chain.end());
    }
    return chain;
}

}  // namespace csg::reference
