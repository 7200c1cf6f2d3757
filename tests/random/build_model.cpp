#include "tests/random/build_model.h"

#include <glm/gtc/matrix_transform.hpp>

namespace random_tree {

Model leaf(csg::LeafShape shape) {
    return {csg::Operation::Leaf, {}, std::move(shape), glm::dmat4(1.0), {}, {}};
}

Model combine(csg::Operation operation, std::vector<Model> children) {
    return {operation, {}, csg::Cube{}, glm::dmat4(1.0), {}, std::move(children)};
}

Model matrix(const glm::dmat4& m, Model child) {
    return {csg::Operation::Transform, {}, csg::Cube{}, m, {}, {std::move(child)}};
}

Model at(const glm::dvec3& p, Model child) {
    return matrix(glm::translate(glm::dmat4(1.0), p), std::move(child));
}

Model box(const glm::dvec3& lo, const glm::dvec3& size) {
    return at(lo, leaf(csg::Cube{size, false}));
}

}  // namespace random_tree
