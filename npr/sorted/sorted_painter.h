// Transparency as most programs have it: triangles drawn one after the other, back to front, and blended.
#pragma once

#include <vector>

#include "npr/colored_mesh.h"
#include "npr/painter/cpu_frame.h"
#include "npr/part_notes.h"
#include "npr/sorted/index_sort.h"
#include "npr/sorted/sorted_layers.h"

namespace npr {

/// Draws one mesh, frame after frame.
class SortedPainter {
  public:
    explicit SortedPainter(ColoredMesh mesh);

    /// A frame in style shaded, whose layers are not looked at. `first`: the first sample of a picture, for which
    /// triangles are sorted.
    void paint(const CpuFrame& frame, bool first);
    /// All triangles as layers, for `paint_styled`; stands until the next call. `table`: of the mesh's faces.
    [[nodiscard]] const layers::HostStack& layers(const base::View& view,
                                                  const std::shared_ptr<const layers::SurfaceTable>& table);
    /// A frame in any styles, whose layers are those above or some of them: the styles color them, and they are
    /// blended in the order of the triangles.
    void paint_styled(const CpuFrame& frame, bool first);
    /// What each sort has taken so far.
    [[nodiscard]] const std::vector<SortCount>& counts() const { return counts_; }
    [[nodiscard]] const ColoredMesh& mesh() const { return mesh_; }

  private:
    void sort(const Picture& picture, const base::View& view);
    /// By triangle, when it is drawn.
    [[nodiscard]] std::vector<std::uint32_t> places() const;

    ColoredMesh mesh_;
    std::vector<std::uint32_t> opaque_, clear_;  ///< Triangles.
    IndexSort by_distance_;                      ///< Of clear_.
    std::vector<SortCount> counts_;
    SortedLayers layers_;
    PartNotes notes_;
};

}  // namespace npr
