// Models of one program while it is edited: where an edit has only moved things, the model before follows.
#pragma once

#include <memory>
#include <stop_token>

#include "ui/pipeline/model.h"
#include "ui/pipeline/moving_model.h"

namespace ui {

class FollowingBuilder {
  public:
    // As ModelBuilder has them.
    void show(csg::Showing showing);
    void divide(csg::PartRule parts);
    void cut(npr::Sections sections);

    /// What ModelBuilder::build() gives, but for holes in the numbers of its planes. Where the tree differs from the
    /// last one in where some leaves are, only those are placed.
    [[nodiscard]] std::shared_ptr<const Model> build(std::shared_ptr<const csg::Tree> tree,
                                                     const std::stop_token& stop = {},
                                                     std::shared_ptr<const csg::scad::LoadedProgram> program = {});

    /// The last model was made of the one before.
    [[nodiscard]] bool followed() const { return followed_; }

  private:
    /// The next model is built anew.
    void forget();
    [[nodiscard]] std::shared_ptr<Model> follow(const csg::Tree& tree);

    ModelBuilder builder_;
    csg::Showing showing_ = csg::Showing::Preview;
    csg::PartRule parts_;
    npr::Sections sections_;
    std::shared_ptr<const Model> last_;    ///< Null where it is of no use.
    std::unique_ptr<MovingModel> moving_;  ///< A copy of it, as soon as it was of use.
    bool followed_ = false;
};

}  // namespace ui
