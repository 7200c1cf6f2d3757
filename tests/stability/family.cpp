#include "tests/stability/family.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace stability {

std::vector<Family> families() {
    std::vector<Family> all;
    add_coincident(all);
    add_thin(all);
    add_scales(all);
    add_counts(all);
    add_meshes(all);
    add_windings(all);
    add_views(all);
    return all;
}

Maker::Id Maker::sphere(const glm::dvec3& center, double radius, double sides) {
    return at(center, leaf(csg::Sphere{radius, {sides, 12, 2}}));
}

Maker::Id Maker::cylinder(const glm::dvec3& base, double height, double radius, double sides) {
    return at(base, leaf(csg::Cylinder{height, radius, radius, false, {sides, 12, 2}}));
}

Maker::Id Maker::mesh(std::vector<glm::dvec3> points, std::vector<std::vector<std::uint32_t>> faces) {
    csg::Polyhedron polyhedron;
    polyhedron.points = std::move(points);
    polyhedron.faces = std::move(faces);
    return leaf(std::make_shared<const csg::Polyhedron>(std::move(polyhedron)));
}

Maker::Id Maker::at(const glm::dvec3& p, Id child) {
    return place(glm::translate(glm::dmat4(1.0), p), child);
}

Maker::Id Maker::scale(const glm::dvec3& s, Id child) {
    return place(glm::scale(glm::dmat4(1.0), s), child);
}

Maker::Id Maker::turn(double degrees, const glm::dvec3& axis, Id child) {
    return place(glm::rotate(glm::dmat4(1.0), glm::radians(degrees), axis), child);
}

Case Maker::seen(Id root, const glm::dvec3& eye, const glm::dvec3& center, double fov) {
    base::Camera camera = base::camera_between(eye, center);
    camera.fov = fov;
    return {builder_.finish(root), camera};
}

std::vector<double> powers_of_ten(int first, int step, int count) {
    std::vector<double> levels;
    for (int i = 0; i < count; ++i) {
        levels.push_back(std::pow(10.0, first - i * step));
    }
    return levels;
}

}  // namespace stability
