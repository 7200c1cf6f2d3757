// What a style draws, layer by layer instead of put together, so that what other styles draw can lie between.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "npr/painter/cpu_tiles.h"

namespace npr {

/// A surface, or a piece of a line, that is seen in a pixel.
struct Note {
    glm::vec4 color{0};      ///< sRGB with straight alpha.
    float depth = 0;         ///< Reversed.
    std::uint32_t rank = 0;  ///< One more than that of the part; 0 for lines. In one place the lowest is nearest.
};

/// The notes of a tile's pixels, row by row.
class TileNotes {
  public:
    void clear() {
        notes_.clear();
        ends_.clear();
    }
    /// The next of the pixel. It is taken to be as deep as the one before, at least: a style's own order stands.
    void add(const Note& note) {
        const std::size_t first = ends_.empty() ? 0 : ends_.back();
        notes_.push_back(note);
        if (notes_.size() > first + 1) {
            notes_.back().depth = glm::min(note.depth, notes_[notes_.size() - 2].depth);
        }
    }
    /// All of them are seen through by that much more.
    void fade(float opacity) {
        for (Note& note : notes_) {
            note.color.a *= opacity;
        }
    }
    [[nodiscard]] bool pixel_is_empty() const { return notes_.size() == (ends_.empty() ? 0 : ends_.back()); }
    void end_pixel() { ends_.push_back(notes_.size()); }

    /// Of a pixel, nearest first.
    [[nodiscard]] std::span<const Note> of(std::size_t pixel) const {
        const std::size_t first = pixel == 0 ? 0 : ends_[pixel - 1];
        return std::span(notes_).subspan(first, ends_[pixel] - first);
    }

  private:
    std::vector<Note> notes_;
    std::vector<std::size_t> ends_;
};

/// By tile of a frame.
using LayerNotes = std::vector<TileNotes>;

}  // namespace npr
