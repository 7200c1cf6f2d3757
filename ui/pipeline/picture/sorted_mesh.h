// The mesh that `--transparency sorted` draws.
#pragma once

#include <stop_token>

#include "npr/sorted/sorted_painter.h"
#include "ui/pipeline/model.h"

namespace ui {

/// Is the picture drawn of sorted triangles? Styles other than shaded draw layers, whatever the model of transparency.
[[nodiscard]] bool draws_sorted(const npr::Picture& picture);

/// The reference mesh of each part by itself, `%` and `#` too, with the colors that styles give its surfaces. Throws
/// ModelError where a part has no closed mesh, base::Stopped where `stop` asked for it.
[[nodiscard]] npr::ColoredMesh colored_mesh(const Model& model, const npr::ColorScheme& scheme,
                                            const std::stop_token& stop = {});

}  // namespace ui
