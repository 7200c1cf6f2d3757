// Transparency as most programs have it: triangles drawn one after the other, back to front, and blended.
#pragma once

#include <vector>

#include "npr/painter/cpu_frame.h"
#include "npr/sorted/index_sort.h"

namespace npr {

/// Triangles of several parts in world coordinates, counter-clockwise seen from outside.
struct ColoredMesh {
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;
    std::vector<glm::vec4> colors;     ///< By triangle: sRGB, not lit, straight alpha.
    std::vector<std::uint32_t> parts;  ///< By triangle, in ascending order.
};

/// Draws one mesh, frame after frame.
class SortedPainter {
  public:
    explicit SortedPainter(ColoredMesh mesh);

    /// A frame whose layers are not looked at. `first`: the first sample of a picture, for which triangles are sorted.
    void paint(const CpuFrame& frame, bool first);
    /// What each sort has taken so far.
    [[nodiscard]] const std::vector<SortCount>& counts() const { return counts_; }
    [[nodiscard]] const ColoredMesh& mesh() const { return mesh_; }

  private:
    void sort(const Picture& picture, const base::View& view);

    ColoredMesh mesh_;
    std::vector<std::uint32_t> opaque_, clear_;  ///< Triangles.
    IndexSort by_distance_;                      ///< Of clear_.
    std::vector<SortCount> counts_;
};

}  // namespace npr
