// Random operands of Minkowski sums, as OpenSCAD programs.
#pragma once

#include <random>
#include <string>

namespace random_operands {

/// Convex: boxes, balls, cylinders, cones, hulls, plates so thin that they hardly have a volume; some are turned.
[[nodiscard]] std::string convex(std::mt19937_64& random);

/// Not convex: unions and differences of boxes (which touch often), prisms with holes, L shapes, revolutions, rings,
/// twisted bars, cavities, thin plates, shells that overlap; some are turned.
[[nodiscard]] std::string general(std::mt19937_64& random);

}  // namespace random_operands
