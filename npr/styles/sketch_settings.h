// What both painters of sketches make of the style's parameters.
#pragma once

#include <optional>

#include "base/camera.h"
#include "npr/edges/line_types.h"
#include "npr/settings.h"
#include "npr/styles/relief.h"

namespace npr {

/// Lengths in pixels.
struct SketchSettings : LinedSettings {
    glm::uint seed{};
    /// A 512th of the picture's height: drawings of all sizes look the same, though with finer lines the larger they
    /// are.
    float unit{};
    float hidden_inner{};  ///< Strength of hidden edges where a surface bends.
    float wobble{};
    int strokes{};
    float overshoot_length{};
    int medium{};  ///< 0: pencil, 1: ink, 2: chalk.
    float hatch{};
    float wash{};
    float hidden{};
    float hidden_falloff{};  ///< From one hidden layer to the next.
    float layer_tone{};      ///< Of each surface behind a pixel.
    bool smooth_shading{};
    bool on_model{};    ///< The noise is anchored to the model, else to the picture.
    bool correlated{};  ///< Perlin noise, else every pixel has its own (chalk).
    glm::vec3 ink_color{};
    glm::vec3 paper_color{};

    void complete(const Picture& picture);
    /// Of the style `sketch`.
    static const SettingsTable<SketchSettings>& table();
};

/// What styles drawn by hand differ in: initial values, and parameters that not all of them have.
struct HandParameters {
    float width = 1, wobble = 0;
    int strokes = 1;
    float overshoot = 0;
    glm::vec3 ink{}, paper{};
    std::optional<Parameter> medium{}, hatch{}, wash{}, hidden{}, hidden_falloff{}, layer_tone{}, smooth_shading{};
};
[[nodiscard]] SettingsTable<SketchSettings> hand_table(const HandParameters& hand);

/// The widest stroke.
[[nodiscard]] constexpr float widest_stroke(const SketchSettings& settings) {
    return 2 * settings.width;
}

/// What the noise of a picture depends on, beside what the picture's first sample sees where it lies on the model.
struct NoiseKey {
    glm::ivec2 size{0};
    int guard = 0;
    glm::uint seed = 0;
    bool correlated = true, on_model = false;
    bool operator==(const NoiseKey&) const = default;
};

[[nodiscard]] NoiseKey noise_key(const SketchSettings& settings, glm::ivec2 size, int guard);

/// What the noise lies on where it is anchored to the model. `depths`: by pixel, of the first layer; `center` (world)
/// and `diagonal`: of the scene.
[[nodiscard]] Relief sketch_relief(const base::View& view, std::span<const float> depths,
                                   const SketchSettings& settings, const glm::dvec3& center, double diagonal);

}  // namespace npr
