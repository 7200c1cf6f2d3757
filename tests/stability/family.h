// Families of hard models, each with one difficulty that grows.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "csg/tree/tree.h"

namespace stability {

/// A model of a family, and the camera that shows what is hard in it (perspective; the orthographic picture is taken by
/// the same camera).
struct Case {
    csg::Tree tree;
    base::Camera camera;
};

struct Family {
    std::string name;
    std::string what;        ///< A sentence for readers.
    std::string difficulty;  ///< What grows or shrinks, with its unit.
    std::vector<double> levels;
    std::function<Case(double level)> make;
};

/// All families.
[[nodiscard]] std::vector<Family> families();

// One file each.
void add_coincident(std::vector<Family>& families);
void add_thin(std::vector<Family>& families);
void add_scales(std::vector<Family>& families);
void add_counts(std::vector<Family>& families);
void add_meshes(std::vector<Family>& families);
void add_windings(std::vector<Family>& families);
void add_views(std::vector<Family>& families);

/// Builds trees in a line or two. Nothing recurses, so that chains may be long.
class Maker {
  public:
    using Id = csg::NodeId;

    Id leaf(csg::LeafShape shape) { return builder_.leaf(std::move(shape), {}); }
    Id box(const glm::dvec3& lo, const glm::dvec3& size) { return at(lo, leaf(csg::Cube{size, false})); }
    Id sphere(const glm::dvec3& center, double radius, double sides = 24);
    /// Upright, from `base` on.
    Id cylinder(const glm::dvec3& base, double height, double radius, double sides = 24);
    Id mesh(std::vector<glm::dvec3> points, std::vector<std::vector<std::uint32_t>> faces);
    Id combine(csg::Operation operation, const std::vector<Id>& children) {
        return builder_.combine(operation, children, {});
    }
    Id unite(const std::vector<Id>& children) { return combine(csg::Operation::Union, children); }
    Id subtract(const std::vector<Id>& children) { return combine(csg::Operation::Difference, children); }
    Id intersect(const std::vector<Id>& children) { return combine(csg::Operation::Intersection, children); }
    Id place(const glm::dmat4& matrix, Id child) { return builder_.transform(matrix, std::vector<Id>{child}, {}); }
    Id at(const glm::dvec3& p, Id child);
    Id scale(const glm::dvec3& s, Id child);
    /// Degrees about an axis.
    Id turn(double degrees, const glm::dvec3& axis, Id child);

    /// The finished model seen from `eye`; `fov` in degrees.
    Case seen(Id root, const glm::dvec3& eye, const glm::dvec3& center, double fov = 30);

  private:
    csg::TreeBuilder builder_;
};

/// Difficulties 10^first, 10^(first - step), …, `count` of them.
[[nodiscard]] std::vector<double> powers_of_ten(int first, int step, int count);

}  // namespace stability
