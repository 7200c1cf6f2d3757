// What is written into the window's picture: laid out anew for each view, and nothing else is made anew for that.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "ui/pipeline/annotation/annotation.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {

/// Belongs to the thread that draws.
class LabelLayer {
  public:
    /// The model with glyphs for the whole picture; the model itself where there is no room for them, or none are
    /// wanted. Both live until the next call. `version`: another one for each model and view.
    const Model& annotated(const Model& model, const PictureRequest& picture,
                           const std::shared_ptr<const Annotations>& wanted, std::uint64_t version);
    /// A model has been changed in place: see Renderer::update.
    void update(const Model& model, const csg::solid::SceneChange& change);

    /// Why there are none, of the last call; empty where there are.
    [[nodiscard]] const std::string& error() const { return error_; }
    /// They take longer than a picture may that follows the hand.
    [[nodiscard]] bool slow() const { return milliseconds_ > kMost; }

  private:
    static constexpr double kMost = 80;

    std::optional<Renderer> peeler_;  ///< Of its own: the one that draws holds the model with the glyphs.
    std::shared_ptr<const Model> annotated_;
    std::shared_ptr<const Annotations> of_;
    std::uint64_t version_ = 0;
    std::string error_;
    double milliseconds_ = 0;
};

}  // namespace ui
