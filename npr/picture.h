// What a picture is to be.
#pragma once

#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "base/camera.h"
#include "layers/limits.h"
#include "npr/color_scheme.h"
#include "npr/parameter.h"
#include "npr/part_style.h"
#include "npr/section.h"
#include "npr/transparency.h"

namespace npr {

struct StyleInfo;

/// As many layers as the style looks at, or all that there are.
inline constexpr int kLayersOfStyle = -1, kAllLayersWanted = layers::kAllLayers;

/// All that is wished of a picture, typed: whoever reads text (the command line) or has controls (the window) fills
/// this one value, and both painters see it by reference (Frame, CpuFrame).
///
/// A new wish that concerns every style is a field here, and its readers. Shaders read it by its name once it has a
/// field and a line in npr/frame_values.h, too; a wish about what is peeled (a section, what is revealed) is read where
/// the layers are made, in ui/pipeline/picture. The command line and the window add an option or a control; nothing in
/// between hands it on.
struct Picture {
    const StyleInfo* style = nullptr;  ///< Null only in a picture that is still being made. See draw_as.
    Parameters parameters;             ///< Of the style.
    ColorScheme scheme;
    base::Camera camera;
    glm::ivec2 size{512, 512};    ///< Pixels.
    int guard = 0;                ///< Pixels at each side that are drawn but not shown: npr/guard_band.h.
    double dots_per_inch = 0;     ///< Of the picture where it is printed; 0: not said.
    int samples = 4;              ///< Per pixel, as npr::sample_offsets takes them.
    int layers = kLayersOfStyle;  ///< The first so many, or one of the constants above.
    Sections sections;            ///< What is cut away.
    Transparency transparency = Transparency::Exact;
    Parameters transparency_parameters;   ///< Of that model; where they are another's, its defaults hold.
    std::vector<PartMedium> media;        ///< In Volume: of parts; what is not said follows from color and opacity.
    MediumLight medium_light;             ///< In Volume.
    std::vector<PartStyle> part_styles;   ///< Of parts that are not drawn in `style`.
    std::vector<RevealedPart> reveal;     ///< Parts that are to be seen, whatever hides them.
    bool transparent_background = false;  ///< Leave alpha 0 where nothing is drawn.

    /// 96 pixels an inch where nothing is said.
    [[nodiscard]] double pixels_per_millimeter() const { return (dots_per_inch > 0 ? dots_per_inch : 96) / 25.4; }
    /// Another style, with its parameters' defaults.
    void draw_as(const StyleInfo& info);
    /// Another model of transparency, with its parameters' defaults.
    void see_through_as(const TransparencyInfo& info);

    /// Whether both ask for the same pixels.
    bool operator==(const Picture&) const = default;
};

/// Is a toggle of that label on, in the style of the picture or of one of its parts?
[[nodiscard]] bool has_on(const Picture& picture, std::string_view label);

/// The default style in the default color scheme.
[[nodiscard]] Picture default_picture();

}  // namespace npr
