// Large and small numbers: places, sizes, matrices.
#include <glm/gtc/matrix_transform.hpp>

#include "tests/stability/family.h"

namespace stability {

namespace {

using Id = Maker::Id;
const glm::dvec3 kEye(13, -17, 15);

/// A part with shared faces, a hole and a boss; about 8 wide.
Id part(Maker& m) {
    return m.subtract({m.unite({m.box({-4, -4, 0}, {8, 8, 3}), m.cylinder({0, 0, 3}, 2, 3)}),
                       m.cylinder({0, 0, 0}, 5, 1.5), m.box({2, -4, 2}, {2, 8, 1})});
}

/// A channel along y, this long either way: its profile is a U, 2 wide and 2 high.
Id channel(Maker& m, double reach) {
    const glm::dvec2 profile[]{{-1, 0}, {1, 0}, {1, 2}, {0.5, 2}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, 2}, {-1, 2}};
    std::vector<glm::dvec3> points;
    std::vector<std::vector<std::uint32_t>> faces(2);
    for (std::uint32_t i = 0; i < 8; ++i) {
        points.emplace_back(profile[i].x, -reach, profile[i].y);
        points.emplace_back(profile[i].x, reach, profile[i].y);
        faces[0].push_back(2 * (7 - i));
        faces[1].push_back(2 * i + 1);
        const std::uint32_t next = (i + 1) % 8;
        faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    }
    return m.mesh(std::move(points), std::move(faces));
}

}  // namespace

void add_scales(std::vector<Family>& all) {
    all.push_back(
        {"endless leaves",
         "A block between endless plates, crossed by an endless channel and by a slanted endless bar.",
         "reach / size",
         {1, 1e1, 1e2, 1e4, 1e6, 1e8, 1e10},
         [](double factor) {
             Maker m;
             const double r = 8 * factor;
             const Id block = m.intersect({m.box({-4, -4, -r}, {8, 8, 2 * r}), m.box({-r, -r, 0}, {2 * r, 2 * r, 4})});
             const Id bar = m.at({0, 0, 2}, m.turn(33, {0.2, 1, 0.1}, m.box({-r, -0.5, -0.5}, {2 * r, 1, 1})));
             return m.seen(m.subtract({block, m.at({1, 0, 2}, channel(m, r)), bar}), kEye, {0, 0, 2});
         }});
    all.push_back({"far from the origin",
                   "A part this far away, in its own size.",
                   "distance / size",
                   {0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6},
                   [](double distance) {
                       Maker m;
                       const glm::dvec3 place = distance * glm::dvec3(8, -5, 3);
                       const Id placed = m.at(place, part(m));
                       return m.seen(placed, place + kEye, place + glm::dvec3(0, 0, 2));
                   }});
    all.push_back(
        {"small in a large scene",
         "A part beside a block this many times as large.",
         "ratio",
         {1, 10, 100, 1e3, 1e4, 1e5, 1e6},
         [](double ratio) {
             Maker m;
             const Id both = m.unite({part(m), m.box({-8 * ratio, 6, -1}, {16 * ratio, 16 * ratio, 8 * ratio})});
             return m.seen(both, kEye, {0, 0, 2});
         }});
    all.push_back(
        {"all sizes", "A part of this size.", "scale", {1e-6, 1e-4, 1e-2, 1, 1e2, 1e4, 1e6}, [](double scale) {
             Maker m;
             const Id scaled = m.scale(glm::dvec3(scale), part(m));
             return m.seen(scaled, scale * kEye, scale * glm::dvec3(0, 0, 2));
         }});
    all.push_back({"turned step by step",
                   "A block less its copy turned n times by 360/n degrees.",
                   "n",
                   {3, 7, 11, 49, 101, 999},
                   [](double n) {
                       Maker m;
                       glm::dmat4 matrix(1.0);
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           matrix = matrix * glm::rotate(glm::dmat4(1.0), glm::radians(360.0 / n), {0.1, 0.2, 0.9});
                       }
                       const Id none = m.subtract({part(m), m.place(matrix, part(m))});
                       return m.seen(m.unite({none, m.box({5, -1, 0}, {1, 2, 2})}), kEye, {0, 0, 2});
                   }});
    all.push_back({"squeezed",
                   "A part squeezed along one axis, and stretched again by a cut of equal shape.",
                   "factor",
                   {1, 10, 1e2, 1e3, 1e4, 1e6},
                   [](double factor) {
                       Maker m;
                       const Id flat = m.scale({1, 1, 1 / factor}, m.box({-4, -4, 0}, {8, 8, 8 * factor}));
                       return m.seen(m.subtract({flat, m.box({-2, -2, 0}, {4, 4, 8}), m.box({-4, -4, 4}, {3, 8, 4})}),
                                     {13, -17, 25}, {0, 0, 4});
                   }});
    all.push_back(
        {"zero scale", "A cutter and a block scaled flat.", "scale", {1, 1e-2, 1e-6, 1e-9, 1e-12, 0}, [](double scale) {
             Maker m;
             const Id cut = m.subtract({m.box({-4, -4, 0}, {8, 8, 4}),
                                        m.at({0, 0, 4}, m.scale({1, 1, scale}, m.box({-2, -2, -3}, {4, 4, 6})))});
             const Id flat = m.at({0, 0, 6}, m.scale({1, 1, scale}, m.sphere({0, 0, 0}, 2)));
             return m.seen(m.unite({cut, flat}), kEye, {0, 0, 4});
         }});
    all.push_back(
        {"mirrored", "Mirrored copies of a part, flush with each other.", "copies", {1, 2, 3, 4, 5, 6}, [](double n) {
             Maker m;
             std::vector<Id> copies;
             glm::dmat4 matrix(1.0);
             for (int i = 0; i < static_cast<int>(n); ++i) {
                 copies.push_back(m.place(matrix, m.at({4, 4, 0}, part(m))));
                 glm::dvec3 mirror(1.0);
                 mirror[i % 3] = -1;
                 matrix = matrix * glm::scale(glm::dmat4(1.0), mirror);
             }
             return m.seen(m.unite(copies), {26, -34, 30}, {0, 0, 0});
         }});
    all.push_back({"sheared",
                   "A part and its cutter, both sheared by so much.",
                   "shear",
                   {0, 1, 3.3, 10, 100, 1000},
                   [](double shear) {
                       Maker m;
                       glm::dmat4 matrix(1.0);
                       matrix[2][0] = shear;
                       const Id sheared = m.place(matrix, part(m));
                       const double s = 1 + shear;
                       return m.seen(sheared, {2 * shear + 13 * s, -17 * s, 15 * s}, {2 * shear, 0, 2});
                   }});
}

}  // namespace stability
