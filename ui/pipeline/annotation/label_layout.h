// Where labels go in a picture: beside what they name, not over each other, over the model only where there is no room.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "layers/host_stack.h"

namespace ui {

/// A rectangle of a picture: pixels from its lower left corner, as in base::View.
struct PixelBox {
    glm::dvec2 lo{0.0}, hi{0.0};
    [[nodiscard]] glm::dvec2 size() const { return hi - lo; }
    [[nodiscard]] PixelBox grown(double by) const { return {lo - by, hi + by}; }
};
[[nodiscard]] bool overlap(const PixelBox& a, const PixelBox& b);
/// Does the line from `a` to `b` meet the box?
[[nodiscard]] bool meets(const PixelBox& box, const glm::dvec2& a, const glm::dvec2& b);
/// Do the two lines cross?
[[nodiscard]] bool cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d);

/// The pixels that the model takes in a picture, ready to be counted in any rectangle.
class Coverage {
  public:
    /// Of a picture in which there is nothing.
    explicit Coverage(glm::ivec2 size);
    /// Where the stack's first layer has a surface.
    explicit Coverage(const layers::HostStack& stack);
    [[nodiscard]] glm::ivec2 size() const { return size_; }
    [[nodiscard]] std::int64_t pixels(const PixelBox& box) const;

  private:
    glm::ivec2 size_;
    std::vector<std::uint32_t> sums_;  ///< (x, y): pixels to the left of and below it.
};

struct LabelBox {
    glm::dvec2 size{0.0};    ///< Pixels.
    glm::dvec2 anchor{0.0};  ///< What it is to be near, …
    bool leader = true;      ///< … with a line from there to the middle of one of its sides.
    bool aside = true;       ///< It keeps clear of the model.
};

struct PlacedLabel {
    PixelBox box;
    glm::dvec2 end{0.0};        ///< Of its leader, at the box; the anchor, where there is none.
    std::int64_t of_model = 0;  ///< Pixels of the model that it covers.
};

/// Boxes do not overlap, keep clear of leaders and anchors of others where they can, and of the model where there is
/// room; then leaders are short. Each is put where that is best, and again when all are there; the same labels give the
/// same places. `taken`: where none may be. Nothing where there is no room for all of them.
[[nodiscard]] std::optional<std::vector<PlacedLabel>> lay_out(const Coverage& model, std::span<const LabelBox> labels,
                                                              std::span<const PixelBox> taken = {});

}  // namespace ui
