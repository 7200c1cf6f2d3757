// Depiction techniques: what moves, in a picture that stands still (Nienhaus 2005, sections 7.5 to 7.7).
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/camera.h"
#include "csg/tree/scene.h"
#include "csg/tree/tree.h"
#include "npr/part_style.h"
#include "ui/pipeline/annotation/annotation.h"
#include "ui/pipeline/motion/depiction_expression.h"
#include "ui/pipeline/motion/motion.h"

namespace ui {

/// What depictions are made of.
struct DepictionSource {
    const csg::Tree& model;  ///< At the present.
    const Motion& motion;    ///< Over an interval that holds the times of all depictions.
    double now = 0;          ///< $t
    /// The program's camera at a time, as far as it says where that is; for `camera`.
    std::function<base::Camera(double time)> camera_at;
    double aspect = 1;  ///< Of the picture: width by height.
};

/// A glyph in a style of its own: the part that has that color.
struct GlyphStyle {
    csg::Rgba color;       ///< No other part has it.
    npr::PartStyle drawn;  ///< Of no part yet.
};

/// Of no part yet; none where the depiction names no style. Throws std::runtime_error, with the place and what was
/// expected there, where there is no such style, parameter or value.
[[nodiscard]] std::optional<npr::PartStyle> style_of(const Depiction& depiction);

struct Depicted {
    csg::Tree tree;                      ///< The model with glyphs: shapes in the scene, drawn as all others are.
    std::vector<BubbleRequest> bubbles;  ///< Glyphs that are turned to whoever looks, …
    std::vector<FrameRequest> frames;    ///< … to be put before the scene when it is known from where.
    std::vector<GlyphStyle> styles;      ///< Of glyphs that have one.
};

/// Throws std::runtime_error where a depiction names no body that moves (and the nearest that does), or one that does
/// not do what the technique shows; base::Stopped where it was asked for.
[[nodiscard]] Depicted depict(const DepictionSource& source, const std::vector<Depiction>& depictions,
                              const std::stop_token& stop = {});

/// The same, but what cannot be drawn is left out: `problems` says why, by depiction; empty where it is drawn.
[[nodiscard]] Depicted depict_what_can(const DepictionSource& source, const std::vector<Depiction>& depictions,
                                       std::vector<std::string>& problems, const std::stop_token& stop = {});

/// The styles of the parts that glyphs with a style are in the scene of the tree with them.
[[nodiscard]] std::vector<npr::PartStyle> styles_of_glyphs(const csg::Scene& scene,
                                                           const std::vector<GlyphStyle>& glyphs);

}  // namespace ui
