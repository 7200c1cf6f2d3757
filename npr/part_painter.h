// Pictures whose parts are drawn in styles of their own.
#pragma once

#include <map>
#include <vector>

#include "npr/painter/cpu_frame.h"
#include "npr/painter/layer_notes.h"

namespace npr {

/// Paints pictures that have part_styles. Each style sees the layers of its own parts alone, as if there were nothing
/// else, so that what one part looks like changes nothing in another; it notes what it draws of each layer
/// (layer_notes.h), and the notes of all styles are put over each other by depth. Styles that do not walk the layers
/// (blueprint, sketch, radiograph) give a picture that lies where the first surface of their parts does. The ground is
/// that of the picture's own style.
class PartPainter {
  public:
    /// As Paint.
    void operator()(const CpuFrame& frame);

  private:
    struct Group {
        Paint paint;
        layers::HostStack stack;
        LayerNotes notes;
    };
    void paint_ground(const CpuFrame& frame);
    void paint_group(const CpuFrame& frame, std::size_t group, std::span<const std::size_t> group_of_part);
    void put_together(const CpuFrame& frame);

    std::map<std::pair<std::size_t, const StyleInfo*>, Group> groups_;  ///< By place among the picture's styles.
    std::vector<Group*> drawn_;                                         ///< Of the frame.
    std::vector<glm::vec4> ground_;                                     ///< As CpuFrame::sum.
    layers::HostStack empty_;
};

}  // namespace npr
