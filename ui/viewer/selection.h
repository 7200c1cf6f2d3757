// What was clicked: the surfaces behind a point of the picture, and from where in the text each comes.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/pipeline/call_chain.h"
#include "ui/pipeline/picture/pick.h"
#include "ui/viewer/call_at.h"
#include "ui/viewer/text_place.h"

namespace ui {

/// A call on the way to a leaf.
struct SelectedCall {
    std::string call;                 ///< As it is written, shortened.
    std::string place;                ///< "lid.scad:12"
    TextPlace text;                   ///< Its `text` is null where that is not known.
    std::optional<CallAt> explained;  ///< Of a difference or an intersection.
};

struct SelectedSurface {
    PickedSurface surface;
    std::string title;                ///< "cylinder, cut by it, part lid"
    std::vector<SelectedCall> calls;  ///< From the leaf up to the top of the file.
};

/// Refers to nothing of the model. `sources`: of the program that made it.
[[nodiscard]] SelectedSurface selected_surface(const Model& model, const csg::scad::SourceSet& sources,
                                               const PickedSurface& surface);

class Selection {
  public:
    /// What was picked `at` a place of the picture; the first of them counts, or, where the place is that of before,
    /// the next one behind it.
    void take(std::vector<SelectedSurface> surfaces, const glm::dvec2& at);
    void step(int by);
    void clear() { surfaces_.clear(); }

    [[nodiscard]] bool empty() const { return surfaces_.empty(); }
    [[nodiscard]] std::size_t count() const { return surfaces_.size(); }
    [[nodiscard]] std::size_t index() const { return index_; }
    [[nodiscard]] const SelectedSurface& current() const { return surfaces_[index_]; }

  private:
    std::vector<SelectedSurface> surfaces_;
    std::size_t index_ = 0;
    glm::dvec2 at_{0};
};

}  // namespace ui
