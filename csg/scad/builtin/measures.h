// What a program may ask of fonts and drawings. csg/scad only asks, whoever evaluates answers: ui/pipeline with
// csg/solid (DESIGN, section 1).
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "csg/tree/leaf_shape.h"
#include "csg/tree/text_metrics.h"

namespace csg::scad {

/// Of what a drawing is asked: `import` names its file, layer, origin and scale.
struct DrawingQuery {
    Import import;
    std::string file;       ///< As the program names the file, for messages.
    std::string dimension;  ///< Name of a dimension; empty for the first.
};

/// Why there is no answer, or what is odd about it.
struct MeasureWarnings {
    std::vector<std::string> at_call;  ///< Of the question: they have the place of the call.
    std::vector<std::string> of_file;  ///< Of a drawing: they name it, and have no place in the program.
};

/// Each gives nothing where there is no answer, with the reason in `warnings`. Asked from one thread at a time.
class Measures {
  public:
    virtual ~Measures() = default;
    virtual std::optional<TextMetrics> text(const Text& text, MeasureWarnings& warnings) = 0;
    /// Of the font and the size of `text`.
    virtual std::optional<FontMetrics> font(const Text& text, MeasureWarnings& warnings) = 0;
    /// What a dimension in a DXF file measures: units or degrees.
    virtual std::optional<double> dimension(const DrawingQuery& query, MeasureWarnings& warnings) = 0;
    /// Where the first two lines of a DXF file's layer cross.
    virtual std::optional<glm::dvec2> cross(const DrawingQuery& query, MeasureWarnings& warnings) = 0;
};

}  // namespace csg::scad
