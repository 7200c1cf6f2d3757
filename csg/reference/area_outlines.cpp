#include "csg/reference/area_outlines.h"

#include <algorithm>
#include <cmath>

#include "csg/reference/disjoint_sets.h"
#include "csg/reference/face_planes.h"

namespace csg::reference {

namespace {

/// How far a point may lie off the line between its neighbors, of the largest coordinate: some times the rounding of a
/// point in which three planes meet at usual angles.
constexpr double kRounding = 0x1p-44;

}  // namespace

AreaOutlines::AreaOutlines(const Mesh& mesh) : mesh_(mesh), twins_(twins_of(mesh.triangles)) {
    closed_ = std::find(twins_.begin(), twins_.end(), kNoTwin) == twins_.end();
    if (!closed_) {
        return;
    }
    rounding_ = kRounding * largest_coordinate(mesh.points);
    find_areas();
    find_loops();
}

void AreaOutlines::find_areas() {
    const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
    DisjointSets sets(count);
    for (std::uint32_t e = 0; e < 3 * count; ++e) {
        if (mesh_.sources[e / 3] == mesh_.sources[twins_[e] / 3]) {
            sets.unite(e / 3, twins_[e] / 3);
        }
    }
    SetNumbers area_of(sets);
    area_.resize(count);
    for (std::uint32_t t = 0; t < count; ++t) {
        area_[t] = area_of(t);
        if (area_[t] == areas()) {
            first_triangle_.push_back(t);
        }
    }
}

void AreaOutlines::find_loops() {
    std::vector<char> seen(twins_.size(), 0);
    for (std::uint32_t start = 0; start < twins_.size(); ++start) {
        if (seen[start] != 0 || !is_border(start)) {
            continue;
        }
        Loop loop{static_cast<std::uint32_t>(borders_.size()), 0};
        for (std::uint32_t e = start; seen[e] == 0;) {
            seen[e] = 1;
            borders_.push_back(e);
            e = next_border(e);
        }
        loop.last = static_cast<std::uint32_t>(borders_.size());
        loops_.push_back(loop);
    }
}

/// Around the edge's end, through triangles of the same area.
std::uint32_t AreaOutlines::next_border(std::uint32_t edge) const {
    for (edge = after(edge); !is_border(edge);) {
        edge = after(twins_[edge]);
    }
    return edge;
}

bool AreaOutlines::straight(std::uint32_t a, std::uint32_t between, std::uint32_t b) const {
    const glm::dvec3 in = mesh_.points[between] - mesh_.points[a], out = mesh_.points[b] - mesh_.points[between];
    const glm::dvec3 whole = mesh_.points[b] - mesh_.points[a];
    const double off = glm::length(glm::cross(in, whole)), length = glm::length(whole);
    return glm::dot(in, whole) > 0 && glm::dot(out, whole) > 0 && off <= rounding_ * length;
}

template <typename Visit>
void AreaOutlines::for_each_chain(const Loop& loop, Visit&& visit) const {
    const std::uint32_t size = loop.last - loop.first;
    const auto edge = [&](std::uint32_t i) { return borders_[loop.first + i % size]; };
    std::uint32_t start = 0;
    while (start < size && keep_[from(edge(start))] == 0) {
        ++start;
    }
    std::vector<std::uint32_t> chain;
    for (std::uint32_t i = start; i < start + size; ++i) {
        chain.push_back(from(edge(i)));
        if (keep_[to(edge(i))] != 0) {
            chain.push_back(to(edge(i)));
            visit(edge(i), chain);
            chain.clear();
        }
    }
}

template <typename Visit>
void AreaOutlines::for_each_line(Visit&& visit) const {
    for (const Loop& loop : loops_) {
        for_each_chain(loop, [&](std::uint32_t edge, std::span<const std::uint32_t> chain) {
            if (area_[edge / 3] < area_[twins_[edge] / 3]) {
                visit(chain);
            }
        });
    }
}

void AreaOutlines::straighten(std::span<const char> frozen) {
    keep_corners(frozen);
    std::vector<std::vector<std::uint32_t>> long_chains;
    for_each_line([&](std::span<const std::uint32_t> chain) {
        if (chain.size() > 3) {
            long_chains.emplace_back(chain.begin(), chain.end());
        }
    });
    for (const auto& chain : long_chains) {
        keep_bends(chain);
    }
    keep_doubled();
    find_lost();
}

void AreaOutlines::keep_corners(std::span<const char> frozen) {
    constexpr char kMost = 3;
    std::vector<char> ends(mesh_.points.size(), 0);  // Of lines at the point, at most three.
    for (const std::uint32_t e : borders_) {
        ends[from(e)] = std::min<char>(kMost, static_cast<char>(ends[from(e)] + 1));
    }
    keep_.assign(mesh_.points.size(), 0);
    for (std::uint32_t t = 0; t < area_.size(); ++t) {
        for (int k = 0; k < 3 && frozen[area_[t]] != 0; ++k) {
            keep_[mesh_.triangles[t][k]] = 1;
        }
    }
    for (const Loop& loop : loops_) {
        bool any = false;
        for (std::uint32_t i = loop.first; i < loop.last; ++i) {
            const std::uint32_t in = borders_[i], out = borders_[i + 1 < loop.last ? i + 1 : loop.first];
            char& keep = keep_[from(out)];
            if (ends[from(out)] > 2 || !straight(from(in), from(out), to(out))) {
                keep = 1;
            }
            any |= keep != 0;
        }
        for (std::uint32_t i = loop.first; i < loop.last && !any; ++i) {
            keep_[from(borders_[i])] = 1;
        }
    }
}

/// Straight at each point is not straight along the way: as Douglas and Peucker do (1973).
void AreaOutlines::keep_bends(std::span<const std::uint32_t> chain) {
    const glm::dvec3 a = mesh_.points[chain.front()], whole = mesh_.points[chain.back()] - a;
    double most = 0;
    std::size_t at = 0;
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
        const double off = glm::length(glm::cross(mesh_.points[chain[i]] - a, whole));
        if (off > most) {
            most = off;
            at = i;
        }
    }
    if (most <= rounding_ * glm::length(whole)) {
        return;
    }
    keep_[chain[at]] = 1;
    keep_bends(chain.first(at + 1));
    keep_bends(chain.subspan(at));
}

/// Two sheets that touch along an edge may be told apart by a point on it alone.
void AreaOutlines::keep_doubled() {
    struct Line {
        std::uint32_t lo, hi;
        std::vector<std::uint32_t> inner;
    };
    std::vector<Line> lines;
    for_each_line([&](std::span<const std::uint32_t> chain) {
        lines.push_back({std::min(chain.front(), chain.back()),
                         std::max(chain.front(), chain.back()),
                         {chain.begin() + 1, chain.end() - 1}});
    });
    std::sort(lines.begin(), lines.end(),
              [](const Line& a, const Line& b) { return a.lo != b.lo ? a.lo < b.lo : a.hi < b.hi; });
    for (std::size_t i = 0, end; i < lines.size(); i = end) {
        for (end = i + 1; end < lines.size() && lines[end].lo == lines[i].lo && lines[end].hi == lines[i].hi; ++end) {
        }
        for (std::size_t k = i; k < end && end - i > 1; ++k) {
            for (const std::uint32_t point : lines[k].inner) {
                keep_[point] = 1;
            }
        }
    }
}

void AreaOutlines::find_lost() {
    lost_.assign(area_.size(), 0);
    first_lost_.assign(areas() + 1, 0);
    for (std::uint32_t t = 0; t < area_.size(); ++t) {
        const glm::uvec3& corners = mesh_.triangles[t];
        lost_[t] = keep_[corners.x] == 0 || keep_[corners.y] == 0 || keep_[corners.z] == 0;
        first_lost_[area_[t] + 1] += lost_[t] != 0 ? 1 : 0;
    }
    for (std::uint32_t area = 0; area < areas(); ++area) {
        first_lost_[area + 1] += first_lost_[area];
    }
    lost_by_area_.resize(first_lost_.back());
    std::vector<std::uint32_t> at(first_lost_.begin(), first_lost_.end() - 1);
    for (std::uint32_t t = 0; t < area_.size(); ++t) {
        if (lost_[t] != 0) {
            lost_by_area_[at[area_[t]]++] = t;
        }
    }
}

std::vector<AreaEdge> AreaOutlines::border_of_lost(std::uint32_t area) const {
    std::vector<AreaEdge> edges;
    for (const std::uint32_t t : lost_of(area)) {
        for (std::uint32_t e = 3 * t; e < 3 * t + 3; ++e) {
            if (keep_[from(e)] == 0 || (!is_border(e) && lost_[twins_[e] / 3] != 0)) {
                continue;
            }
            std::uint32_t last = e;
            while (keep_[to(last)] == 0) {
                last = next_border(last);
            }
            edges.emplace_back(from(e), to(last));
        }
    }
    return edges;
}

}  // namespace csg::reference
