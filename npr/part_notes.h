// What the styles of a picture draw of its layers, noted layer by layer.
#pragma once

#include <map>
#include <vector>

#include "npr/painter/cpu_frame.h"
#include "npr/painter/layer_notes.h"

namespace npr {

/// Each style of a picture (its own, and its part_styles) sees the layers of its own parts alone, as if there were
/// nothing else, so that what one part looks like changes nothing in another, and notes what it draws of each
/// (layer_notes.h). Styles that do not walk the layers (blueprint, sketch, radiograph) give a picture that lies where
/// the first surface of their parts does. The ground is that of the picture's own style.
class PartNotes {
  public:
    /// Of another frame. Throws base::Stopped where that is asked to end.
    void paint(const CpuFrame& frame);

    /// Of one pixel, what each style has noted, nearest first. `in_tile`: the pixel's place in its tile, row by row.
    void read(int tile, std::size_t in_tile, std::vector<std::span<const Note>>& notes) const;
    /// Takes the nearest note; null where there is none left.
    [[nodiscard]] static const Note* take(std::vector<std::span<const Note>>& notes);
    /// By pixel, linear light, premultiplied alpha; empty where the background is to be left out.
    [[nodiscard]] const std::vector<glm::vec4>& ground() const { return ground_; }

  private:
    struct Group {
        Paint paint;
        layers::HostStack stack;
        std::vector<ShineRow> shine;
        std::vector<ShadowBits> shadows;
        LayerNotes notes;
    };
    Group& group(std::size_t number, const Picture& picture);
    void paint_ground(const CpuFrame& frame);
    void paint_group(const CpuFrame& frame, std::size_t number, std::span<const std::size_t> group_of_part);

    std::map<std::pair<std::size_t, const StyleInfo*>, Group> groups_;  ///< By place among the picture's styles.
    std::vector<Group*> drawn_;                                         ///< Of the frame.
    std::vector<glm::vec4> ground_;
    layers::HostStack empty_;
};

}  // namespace npr
