// How the model is looked at: camera, style with its parameters, scheme, layers, samples.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "npr/style.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {

/// A window always has a background. Style and scheme are indices into npr::styles() and npr::color_schemes().
struct ViewState {
    base::Camera camera;
    std::size_t style = 0;
    std::vector<npr::Parameters> parameters;  ///< By style: each keeps its own while another is shown.
    std::size_t scheme = 0;
    int layers = -1;                                  ///< As PictureRequest::layers.
    int samples = 4;                                  ///< 1, 4, 8 or 16.
    std::optional<goldfeather::EngineKind> engine{};  ///< Absent: chosen for each picture.

    [[nodiscard]] const npr::StyleInfo& style_info() const { return npr::styles()[style]; }
    [[nodiscard]] npr::Parameters& style_parameters() { return parameters[style]; }
    [[nodiscard]] const npr::Parameters& style_parameters() const { return parameters[style]; }
    [[nodiscard]] const npr::ColorScheme& color_scheme() const { return npr::color_schemes()[scheme]; }
    /// The picture of this state, `size` pixels large.
    [[nodiscard]] PictureRequest request(glm::ivec2 size) const;
};

/// The state that a request asks for; its size and its background are left out. Throws as check_picture does.
[[nodiscard]] ViewState view_state_of(const PictureRequest& request);

/// Whether both ask for the same pixels.
[[nodiscard]] bool same_picture(const PictureRequest& a, const PictureRequest& b);

}  // namespace ui
