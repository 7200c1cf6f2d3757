// Thickness of models, pixel by pixel: what the style "radiograph" shows, in millimeters.
#pragma once

#include <stop_token>

#include "base/exr.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {

/// Is the picture one of the style "radiograph"?
[[nodiscard]] bool is_radiograph(const npr::Picture& picture);

/// The length of each pixel's ray within the solid in millimeters, the mean over the picture's samples, as channel "Y".
/// Where the picture is of all of the solid and that has several parts, each has a channel of its name, too (a '.' in
/// it is written '_'). Where parts overlap, "Y" counts once. Throws as Renderer does.
[[nodiscard]] base::FloatImage thickness(Renderer& renderer, const Model& model, const PictureRequest& request,
                                         const std::stop_token& stop = {});

/// The most of "Y" at the pixels' centers; 0 where there is nothing.
[[nodiscard]] double most_thickness(Renderer& renderer, const Model& model, const PictureRequest& request,
                                    const std::stop_token& stop = {});

/// The picture's linear light with premultiplied alpha, as channels R, G, B and A.
[[nodiscard]] base::FloatImage light(Renderer& renderer, const Model& model, const PictureRequest& request,
                                     const std::stop_token& stop = {});

}  // namespace ui
