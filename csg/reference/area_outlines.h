// The flat areas of a closed mesh, and which points their outlines need. For this library's own files.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// From one point to another, the area to the left of it.
using AreaEdge = std::pair<std::uint32_t, std::uint32_t>;

class AreaOutlines {
  public:
    /// Areas are connected triangles with the same source. The mesh must outlive this.
    explicit AreaOutlines(const Mesh& mesh);

    /// Has every directed edge its opposite? Else nothing else may be asked.
    [[nodiscard]] bool closed() const { return closed_; }
    [[nodiscard]] std::uint32_t areas() const { return static_cast<std::uint32_t>(first_triangle_.size()); }
    [[nodiscard]] std::uint32_t area_of(std::uint32_t triangle) const { return area_[triangle]; }
    [[nodiscard]] std::uint32_t first_triangle(std::uint32_t area) const { return first_triangle_[area]; }

    /// Decides which points stay: all of the areas that are `frozen`, and of the others those at which their outlines
    /// are not straight, or more than two areas meet, or without which two edges would have the same ends.
    void straighten(std::span<const char> frozen);
    /// Has the triangle lost a corner?
    [[nodiscard]] bool lost(std::uint32_t triangle) const { return lost_[triangle] != 0; }
    /// The triangles of the area that have, in order.
    [[nodiscard]] std::span<const std::uint32_t> lost_of(std::uint32_t area) const {
        return std::span(lost_by_area_).subspan(first_lost_[area], first_lost_[area + 1] - first_lost_[area]);
    }
    [[nodiscard]] bool any_lost() const { return !lost_by_area_.empty(); }
    /// The outline, with the points that stay, of these triangles of the area.
    [[nodiscard]] std::vector<AreaEdge> border_of_lost(std::uint32_t area) const;

  private:
    struct Loop {
        std::uint32_t first, last;  ///< Into borders_; half-open.
    };

    void find_areas();
    void find_loops();
    void keep_corners(std::span<const char> frozen);
    void keep_bends(std::span<const std::uint32_t> chain);
    void keep_doubled();
    void find_lost();
    [[nodiscard]] std::uint32_t from(std::uint32_t edge) const {
        return mesh_.triangles[edge / 3][static_cast<int>(edge % 3)];
    }
    [[nodiscard]] std::uint32_t to(std::uint32_t edge) const { return from(after(edge)); }
    [[nodiscard]] static std::uint32_t after(std::uint32_t edge) { return edge - edge % 3 + (edge + 1) % 3; }
    [[nodiscard]] bool is_border(std::uint32_t edge) const { return area_[edge / 3] != area_[twins_[edge] / 3]; }
    [[nodiscard]] std::uint32_t next_border(std::uint32_t edge) const;
    [[nodiscard]] bool straight(std::uint32_t a, std::uint32_t between, std::uint32_t b) const;
    /// Calls visit(chain) for the points of the loop from one that stays to the next, both included.
    template <typename Visit>
    void for_each_chain(const Loop& loop, Visit&& visit) const;
    /// The same for the lines between all areas, each once.
    template <typename Visit>
    void for_each_line(Visit&& visit) const;

    const Mesh& mesh_;
    double rounding_ = 0;  ///< How far a point may lie off a straight line.
    bool closed_ = false;
    std::vector<std::uint32_t> twins_;           ///< By edge: 3 t + k from corner k of triangle t.
    std::vector<std::uint32_t> area_;            ///< By triangle.
    std::vector<std::uint32_t> first_triangle_;  ///< By area.
    std::vector<std::uint32_t> borders_;         ///< Edges between areas, loop by loop, the area to their left.
    std::vector<Loop> loops_;
    std::vector<char> keep_;                   ///< By point.
    std::vector<char> lost_;                   ///< By triangle.
    std::vector<std::uint32_t> lost_by_area_;  ///< Triangles.
    std::vector<std::uint32_t> first_lost_;    ///< By area, into those; one more behind.
};

}  // namespace csg::reference
