// What is the same from frame to frame of an animation is not made again.
#pragma once

#include <memory>
#include <optional>

#include "base/image.h"
#include "npr/picture.h"
#include "ui/command_line/options.h"
#include "ui/pipeline/json.h"
#include "ui/pipeline/moving_model.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {

class FilmFrames {
  public:
    /// Must outlive it.
    explicit FilmFrames(const Options& options) : options_(options) {}

    /// The model of this frame's tree, where it is that of the frame before with some leaves elsewhere, or just that;
    /// else null. It is good until the next call. `renderer`: null where there is none yet.
    [[nodiscard]] std::shared_ptr<const Model> follow(const std::shared_ptr<const csg::Tree>& tree,
                                                      const npr::Sections& sections, Renderer* renderer);
    /// It was built for this frame.
    void built(std::shared_ptr<const Model> model, std::shared_ptr<const csg::Tree> tree);

    /// The picture of the frame before, where that of this one would be the same: of the model that was built or
    /// followed last.
    [[nodiscard]] const base::Image* same_image(const npr::Picture& picture) const;
    const base::Image& drew(base::Image image, const npr::Picture& picture);

    /// What became of the frames so far.
    [[nodiscard]] Json figures() const;

  private:
    const Options& options_;
    std::shared_ptr<const Model> model_;     ///< As it was built or moved last, …
    std::shared_ptr<const csg::Tree> tree_;  ///< … and of what.
    std::optional<MovingModel> moving_;      ///< Where it is model_, moved.
    std::optional<base::Image> image_;       ///< Of that model, …
    npr::Picture picture_;                   ///< … drawn so.
    std::size_t drawn_ = 0, leaves_placed_ = 0, leaves_kept_ = 0;
};

}  // namespace ui
