// How thick walls are and how narrow gaps, at every place that a picture shows.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "base/image.h"
#include "ui/pipeline/picture/renderer.h"
#include "ui/pipeline/picture/thickness_request.h"

namespace ui {

/// The smallest place between faces of two calls, or of one.
struct ThinPlace {
    double value = 0;  ///< World units; as exact as csgscope check.
    glm::dvec3 point{0.0}, direction{0.0};
    csg::PartId part = 0;
    csg::OccurrenceId occurrence = csg::kNoOccurrence, other_occurrence = csg::kNoOccurrence;
    glm::dvec2 pixel{0.0};  ///< From the upper left corner.
};

struct ThicknessMap {
    double range = 0;               ///< Of the tones; 0: nothing was measured.
    std::vector<glm::vec3> tint;    ///< By pixel, rows from top to bottom: linear light, to be multiplied with.
    std::vector<ThinPlace> places;  ///< The thinnest first; of two calls that made the faces one, a few in all.
};

/// Measures a picture's samples one after the other, for who shows it before all are there.
class ThicknessGauge {
  public:
    /// Rays run through the model, which must outlive it.
    explicit ThicknessGauge(const Model& model);
    ~ThicknessGauge();
    ThicknessGauge(const ThicknessGauge&) = delete;
    ThicknessGauge& operator=(const ThicknessGauge&) = delete;

    /// What one sample of the picture sees; the first (0) begins a new map. See thickness_map.
    void measure(Renderer& renderer, const Model& shown, const PictureRequest& picture, const ThicknessRequest& request,
                 int sample, const std::stop_token& stop = {});
    /// Of the samples so far.
    [[nodiscard]] ThicknessMap map() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Of the model's surfaces that a picture of `shown` (the model, or what sections leave of it) sees first. Rays run
/// through the model itself, in double precision, whoever finds the layer; faces of sections are measured nowhere, nor
/// are `%` and `#`. Along normals, only roughly opposite faces count, as in csgscope check. Throws as Renderer does.
[[nodiscard]] ThicknessMap thickness_map(Renderer& renderer, const Model& model, const Model& shown,
                                         const PictureRequest& picture, const ThicknessRequest& request,
                                         const std::stop_token& stop = {});

/// The sRGB color of a share (0 to 1) of the range: from red by yellow to pale blue.
[[nodiscard]] glm::vec3 thickness_tone(float share);

/// The model with all of its colors taken away, for light to be multiplied with. Opacities stay.
[[nodiscard]] std::shared_ptr<const Model> without_colors(const Model& model);

/// Multiplies the picture with the tints.
void tint(base::Image& image, const ThicknessMap& map);

/// Tints the picture, draws rings around the places, with their sizes, and the legend on a ground of that
/// color (sRGB).
void draw_thickness(base::Image& image, const ThicknessMap& map, const glm::vec3& ground);

}  // namespace ui
