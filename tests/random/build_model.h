// Models put together by hand.
#pragma once

#include <vector>

#include "tests/random/random_tree.h"

namespace random_tree {

[[nodiscard]] Model leaf(csg::LeafShape shape);
[[nodiscard]] Model combine(csg::Operation operation, std::vector<Model> children);
[[nodiscard]] Model matrix(const glm::dmat4& m, Model child);
[[nodiscard]] Model at(const glm::dvec3& p, Model child);
[[nodiscard]] Model box(const glm::dvec3& lo, const glm::dvec3& size);

}  // namespace random_tree
