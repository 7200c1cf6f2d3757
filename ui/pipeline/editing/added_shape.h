// Shapes that are added by hand, as statements.
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace ui {

enum class AddedShape { Cube, Sphere, Cylinder, Cone, Text, Extrusion };

/// 1, 2 or 5 times a power of ten, the nearest below or at the positive value.
[[nodiscard]] double round_number(double value);
/// The next one, but for a billionth, from there on.
[[nodiscard]] double round_number_above(double value);

/// A statement that makes one about as large as `size`, a round_number(): with the middle of its base `at` a place, or,
/// of a hole, its middle there. Places are rounded to a tenth of the size. There is always a translate() whose numbers
/// can be changed.
[[nodiscard]] std::string statement_of(AddedShape shape, double size, const glm::dvec3& at, bool hole);

}  // namespace ui
