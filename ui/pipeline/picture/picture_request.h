// What a picture is to be.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/camera.h"
#include "npr/accumulate.h"
#include "npr/color_scheme.h"
#include "npr/style.h"
#include "ui/pipeline/model.h"

namespace ui {

struct PictureRequest {
    base::Camera camera;
    glm::ivec2 size{512, 512};
    std::string style = "shaded";
    std::vector<std::pair<std::string, std::string>> settings;  ///< Style parameters by name; the rest are defaults.
    std::string scheme = "Cornfield";
    int layers = -1;  ///< 0: all; below 0: what the style needs.
    int samples = 4;  ///< Per pixel.
    bool transparent_background = false;
    bool flat_lines = true;  ///< Of flat models, where the style draws them: off where draw_flat_lines does.
    std::optional<goldfeather::EngineKind> engine{};  ///< Absent: as the renderer was told.
};

/// Throws std::runtime_error where there is no such style, parameter, value or scheme; names the nearest one.
void check_picture(const PictureRequest& request);

/// The same for the folders below. `style` is valid for ever. Throws as check_picture.
struct CheckedRequest {
    const npr::StyleInfo& style;
    npr::ColorScheme scheme;
    npr::Parameters parameters;

    /// Where the model is `flat` and the style shaded, it is drawn as OpenSCAD's render does: faces without light
    /// between lines of two pixels.
    explicit CheckedRequest(const PictureRequest& request, bool flat = false);
    /// Refers to this and to both arguments.
    /// How many layers are to be peeled (0: all).
    [[nodiscard]] int layers(const Model& model, const PictureRequest& request) const;
    [[nodiscard]] npr::Picture picture(const Model& model, const PictureRequest& request,
                                       const std::stop_token& stop = {}) const;
};

/// Does anything show what is behind it?
[[nodiscard]] bool translucent(const csg::Scene& scene);

}  // namespace ui
