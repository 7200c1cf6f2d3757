// Dimensions and crosses in DXF files: how a program takes its sizes from a drawing.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "csg/solid/dxf_file.h"

namespace csg::solid {

/// Either an answer or why there is none, in OpenSCAD's words.
template <typename T>
struct Measured {
    std::optional<T> value;
    std::string problem;
};

/// OpenSCAD's dxf_dim(): what the dimension of that name says (the first of the layer, where the name is empty), in
/// units of the drawing times `import.scale`, or in degrees. `file_name`: as problems name the file.
[[nodiscard]] Measured<double> dxf_dimension(const DxfFile& file, const Import& import, const std::string& name,
                                             std::string_view file_name);

/// OpenSCAD's dxf_cross(): where the first two lines cross that touch no other. Only lines in the layer count.
[[nodiscard]] Measured<glm::dvec2> dxf_cross(const DxfFile& file, const Import& import, std::string_view file_name,
                                             Remarks& remarks);

}  // namespace csg::solid
