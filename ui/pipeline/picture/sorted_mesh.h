// The mesh that `--transparency sorted` draws.
#pragma once

#include <optional>
#include <stop_token>

#include "npr/sorted/sorted_painter.h"
#include "ui/pipeline/model.h"

namespace ui {

/// Is the picture drawn of sorted triangles? Styles that do not follow its model of transparency draw layers.
[[nodiscard]] bool draws_sorted(const npr::Picture& picture);

/// Of those pictures, are styles to color layers of the triangles (SortedPainter::paint_styled)? Else they are shaded.
[[nodiscard]] bool sorts_layers(const npr::Picture& picture);

/// The reference mesh of each part by itself, `%` and `#` too, with the colors that styles give its surfaces. Throws
/// ModelError where a part has no closed mesh, base::Stopped where `stop` asked for it.
[[nodiscard]] npr::ColoredMesh colored_mesh(const Model& model, const npr::ColorScheme& scheme,
                                            const std::stop_token& stop = {});

/// The last such mesh.
class PartMeshes {
  public:
    /// As colored_mesh; stands until the next call.
    [[nodiscard]] const npr::ColoredMesh& of(const Model& model, const npr::ColorScheme& scheme,
                                             const std::stop_token& stop);
    /// The model has been edited in place.
    void forget() { mesh_.reset(); }

  private:
    std::optional<npr::ColoredMesh> mesh_;
    std::uint64_t generation_ = 0;  ///< Of its model.
    npr::ColorScheme scheme_;
};

}  // namespace ui
