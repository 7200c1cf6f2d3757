// A picture that is wanted of a model.
#pragma once

#include <optional>
#include <utility>

#include "goldfeather/choice.h"
#include "npr/style.h"
#include "ui/pipeline/model.h"

namespace ui {

/// What the picture is to be, and who is to find its surfaces.
struct PictureRequest : npr::Picture {
    PictureRequest() : Picture(npr::default_picture()) {}
    explicit PictureRequest(npr::Picture picture) : Picture(std::move(picture)) {}

    const goldfeather::EngineInfo* engine = nullptr;  ///< Null: as the renderer was told.

    bool operator==(const PictureRequest&) const = default;
};

/// Is the picture of this model drawn as OpenSCAD's render does? So are flat models, shaded.
[[nodiscard]] bool is_flat_picture(const Model& model, const npr::Picture& picture);

/// The picture as it is drawn then: faces without light, with `lines` of two pixels about them (ui::draw_flat_lines
/// draws others).
[[nodiscard]] npr::Picture flat_picture(npr::Picture picture, bool lines);

/// How many layers are to be peeled of the model (0: all).
[[nodiscard]] int layers_to_peel(const npr::Picture& picture, const Model& model);

/// Does anything show what is behind it?
[[nodiscard]] bool translucent(const csg::Scene& scene);

}  // namespace ui
