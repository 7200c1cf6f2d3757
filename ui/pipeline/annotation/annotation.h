// Labels, callouts, bubbles, frames and arrows: glyphs in the scene that say something about it, turned to the viewer
// (Nienhaus 2005, sections 7.2 and 7.9).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "csg/tree/tree.h"
#include "layers/host_stack.h"
#include "npr/part_style.h"
#include "ui/pipeline/annotation/label_layout.h"
#include "ui/pipeline/annotation/part_anchors.h"
#include "ui/pipeline/model.h"

namespace ui {

/// A text with a line to what is seen of some parts, taken together.
struct LabelRequest {
    npr::PartSelector of;
    std::string text;  ///< Line feeds begin lines.
};

/// An arrow along a smooth curve through points of the world.
struct ArrowRequest {
    std::vector<glm::dvec3> points;  ///< At least two.
    std::optional<double> width;     ///< World units; absent: by the model's size.
    std::optional<csg::Rgba> color;
};

/// A speech bubble that points at a point of the world.
struct BubbleRequest {
    glm::dvec3 at{0.0};
    std::string text;
    std::optional<csg::Rgba> color;  ///< Of its outline.
};

/// A frame about points of the world, with a text above it.
struct FrameRequest {
    std::vector<glm::dvec3> points;
    std::string text;             ///< May be empty.
    std::optional<double> width;  ///< Pixels.
    std::optional<csg::Rgba> color;
};

struct Annotations {
    std::vector<LabelRequest> labels;
    bool callouts = false;  ///< A number in a circle at each part (those that differ by a number only have one), and a
                            ///< legend of them.
    std::vector<ArrowRequest> arrows;
    std::vector<BubbleRequest> bubbles;
    std::vector<FrameRequest> frames;
    [[nodiscard]] bool any() const {
        return !labels.empty() || callouts || !arrows.empty() || !bubbles.empty() || !frames.empty();
    }
};

/// A text that was placed.
struct PlacedText {
    std::string text;
    PlacedLabel place;
    glm::dvec2 anchor{0.0};          ///< Pixels from the lower left corner: where its line begins.
    std::optional<PartAnchor> part;  ///< Of labels and callouts.
    std::size_t label = 0;           ///< Of labels: which.
    std::vector<csg::PartId> parts;  ///< That it is of.
};

struct Annotated {
    std::shared_ptr<const Model> model;  ///< With the glyphs as its last part.
    std::vector<PlacedText> texts;
    std::vector<std::size_t> unseen;  ///< Labels whose parts are nowhere in the picture.
};

/// The first layers of the model in the view; 0: all.
using Peel = std::function<std::shared_ptr<const layers::HostStack>(int layers)>;

/// The model with glyphs for that view alone. Texts are before everything, their lines too where they lead to what is
/// seen; to what is hidden they run through the scene. The texts are made smaller until there is room for all; throws
/// ModelError where there is none, no font, or no part of a name, with the nearest names. `background`: sRGB; texts are
/// dark on light ones.
[[nodiscard]] Annotated annotate(const Model& model, const base::View& view, const Peel& peel,
                                 const Annotations& annotations, const glm::vec3& background);

}  // namespace ui
