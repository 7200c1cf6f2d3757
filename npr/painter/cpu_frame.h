// Frames drawn without OpenGL.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <stop_token>

#include "base/camera.h"
#include "layers/host_stack.h"
#include "npr/cast_shadows.h"
#include "npr/colored_mesh.h"
#include "npr/painter/layer_notes.h"
#include "npr/picture.h"
#include "npr/shine/shine_row.h"

namespace npr {

/// One sample per pixel of a picture, to be painted by a style: what Frame (npr/style.h) is for layers in main memory.
struct CpuFrame {
    const Picture& picture;
    const base::View& view;  ///< That `layers` was peeled from, its jitter included.
    const layers::HostStack& layers;
    /// By pixel, rows from bottom to top: linear light, premultiplied alpha. The sample is added to what is there.
    std::span<glm::vec4> sum;
    std::stop_token stop{};  ///< Where it is asked for, the style throws base::Stopped; the sum is undefined then.
    std::span<const ShineRow> shine{};      ///< By pixel, in pictures that need them.
    const ColoredMesh* mesh = nullptr;      ///< Of the parts, in pictures that need it.
    int sample = 0;                         ///< Of the picture, from 0.
    std::span<const ShadowBits> shadows{};  ///< By pixel, in pictures that need them.
    /// Null, or by tile what the style draws is to be noted, and nothing added to the sum.
    LayerNotes* notes = nullptr;
};

/// Paints a frame on all cores: what the style of the same name draws with OpenGL, up to rounding. The bytes depend
/// neither on the machine nor on the number of threads, nor on the frames painted before.
using Paint = std::function<void(const CpuFrame& frame)>;

}  // namespace npr
