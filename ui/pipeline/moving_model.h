// A model from frame to frame of a film: what stays where it was is not placed again.
#pragma once

#include <memory>
#include <optional>

#include "csg/tree/scene.h"
#include "ui/pipeline/editable_model.h"

namespace ui {

/// Do two trees make the same, wherever their texts are?
[[nodiscard]] bool same_content(const csg::Tree& a, const csg::Tree& b);

/// How many leaves are elsewhere in the scene of `tree` than in the model; nothing where it has others, or other
/// expressions.
[[nodiscard]] std::optional<std::size_t> leaves_moved(const Model& model, const csg::Tree& tree,
                                                      const csg::Scene& scene);

class MovingModel {
  public:
    /// A copy of a model that was built for that showing and rule, without sections.
    MovingModel(const Model& model, csg::Showing showing, csg::PartRule rule);

    /// Puts the leaves where `tree` has them. False where it has others, or other expressions, or where the bounds are
    /// not as at first, by which planes and depths are rounded: that model is to be built anew, and this one is of no
    /// use any more. The model is to the last bit what is built of the tree.
    [[nodiscard]] bool follow(const csg::Tree& tree);

    [[nodiscard]] const Model& model() const { return edited_.model(); }
    /// Of the last call, for Renderer::update.
    [[nodiscard]] const csg::solid::SceneChange& change() const { return change_; }
    /// Leaves that it has placed again.
    [[nodiscard]] std::size_t moved() const { return moved_; }

  private:
    csg::Showing showing_;
    csg::PartRule rule_;
    csg::Box box_;
    double reach_;
    EditableModel edited_;
    csg::solid::SceneChange change_;
    std::size_t moved_ = 0;
};

}  // namespace ui
