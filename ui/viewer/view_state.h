// How the model is looked at.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ui/pipeline/picture/picture_request.h"
#include "ui/pipeline/picture/thickness_request.h"

namespace ui {

/// The picture that the window shows. Its size is the window's to say, and a window always has a background.
class ViewState {
  public:
    /// Of one of npr::styles().
    explicit ViewState(const PictureRequest& first);

    PictureRequest picture;
    std::optional<ThicknessRequest> thickness;  ///< Surfaces have the tones of that, not their colors.

    /// The picture, `size` pixels large.
    [[nodiscard]] PictureRequest request(glm::ivec2 size) const;

    /// The style's index in npr::styles().
    [[nodiscard]] std::size_t style() const;
    /// Its parameters are as they were when it was shown last.
    void show_style(std::size_t style);
    /// All parameters of the style at their defaults.
    void reset_parameters();

  private:
    std::vector<npr::Parameters> kept_;  ///< By style, of those that are not shown.
};

}  // namespace ui
