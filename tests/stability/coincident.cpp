// Faces, edges and vertices that coincide, or almost.
#include "tests/stability/family.h"

namespace stability {

namespace {

using Id = Maker::Id;
const glm::dvec3 kAxis(0.3, 0.5, 0.8);
const glm::dvec3 kEye(13, -17, 15);

std::vector<double> angles() {
    return {0, 1, 10, 30.1, 45.7, 89.99, 123.456};
}

std::vector<double> gaps() {
    return powers_of_ten(-1, 1, 12);
}

/// n boxes in a row on one plane, in all roles.
Id torture(Maker& m, int n) {
    std::vector<Id> slabs{m.box({0, 0, 0}, {6, 6, 6})};
    for (int i = 0; i < n; ++i) {
        const double d = i % 6;
        slabs.push_back(m.box({d, d, 0}, {1, 1, 6}));
        slabs.push_back(m.subtract({m.box({d, 0, 5 - d}, {1, 6, 1}), m.box({d, 2, 5 - d}, {1, 1, 1})}));
    }
    return m.subtract(slabs);
}

void add_shared_faces(std::vector<Family>& all) {
    all.push_back({"shared face, difference", "A hole exactly as deep as its plate, turned.", "angle in degrees",
                   angles(), [](double angle) {
                       Maker m;
                       const Id plate = m.subtract({m.box({-4, -4, 0}, {8, 8, 1}), m.box({-1, -1, 0}, {2, 2, 1}),
                                                    m.cylinder({2.5, 2.5, 0}, 1, 1)});
                       return m.seen(m.turn(angle, kAxis, plate), kEye, {0, 0, 0});
                   }});
    all.push_back({"shared face, union", "Blocks that touch: no wall may show between them.", "angle in degrees",
                   angles(), [](double angle) {
                       Maker m;
                       const Id blocks = m.unite({m.box({-3, -1, -1}, {3, 2, 2}), m.box({0, -1, -1}, {3, 2, 2}),
                                                  m.box({-1, 1, -1}, {2, 2, 2})});
                       return m.seen(m.turn(angle, kAxis, blocks), kEye, {0, 0, 0}, 20);
                   }});
    all.push_back({"shared face, intersection", "Blocks that only touch have nothing in common.", "angle in degrees",
                   angles(), [](double angle) {
                       Maker m;
                       const Id none = m.intersect({m.box({-3, -1, -1}, {3, 2, 2}), m.box({0, -1, -1}, {3, 2, 2})});
                       const Id mark = m.box({4, -1, -1}, {1, 2, 2});
                       return m.seen(m.turn(angle, kAxis, m.unite({none, mark})), kEye, {0, 0, 0}, 20);
                   }});
    all.push_back(
        {"skin left by a cut", "A pocket that leaves a skin of this thickness.", "thickness / size", gaps(),
         [](double gap) {
             Maker m;
             const Id plate = m.subtract({m.box({-4, -4, 0}, {8, 8, 8}), m.box({-2, -2, 0}, {4, 4, 8 - 8 * gap})});
             return m.seen(plate, kEye, {0, 0, 4});
         }});
    all.push_back(
        {"cut that reaches beyond", "A hole that passes the face by so much.", "excess / size", gaps(), [](double gap) {
             Maker m;
             const Id plate =
                 m.subtract({m.box({-4, -4, 0}, {8, 8, 8}), m.box({-2, -2, -8 * gap}, {4, 4, 8 + 16 * gap})});
             return m.seen(plate, kEye, {0, 0, 4});
         }});
    all.push_back(
        {"gap between blocks", "Two blocks that do not quite touch.", "gap / size", gaps(), [](double gap) {
             Maker m;
             const Id blocks = m.unite({m.box({-4, -4, 0}, {4 - 8 * gap, 8, 8}), m.box({0, -4, 0}, {4, 8, 8})});
             return m.seen(blocks, kEye, {0, 0, 4});
         }});
    all.push_back(
        {"flush cuts", "A cut whose face lies on those of n leaves.", "leaves", {1, 2, 4, 8, 16, 32, 64}, [](double n) {
             Maker m;
             std::vector<Id> slabs;
             for (int i = 0; i < static_cast<int>(n); ++i) {
                 slabs.push_back(m.box({-4 + 8 * i / n, -4, -i / n}, {8 / n, 8, 4 + i / n}));
             }
             const Id cut = m.subtract({m.unite(slabs), m.box({-4, -4, 2}, {8, 4, 2}), m.cylinder({0, 2, 0}, 4, 1)});
             return m.seen(cut, kEye, {0, 0, 2});
         }});
    all.push_back(
        {"coplanar torture", "Boxes with common planes in all roles.", "boxes / 2", {1, 2, 3, 4, 5, 6}, [](double n) {
             Maker m;
             return m.seen(m.turn(33.3, {0, 0, 1}, torture(m, static_cast<int>(n))), {20, 14, 17}, {1, 4, 3});
         }});
    all.push_back({"flush inlays", "n recesses filled to the brim.", "inlays", {1, 2, 4, 8, 16}, [](double n) {
                       Maker m;
                       Id body = m.box({-4, -4, 0}, {8, 8, 2});
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           const glm::dvec3 lo(-3.5 + 7.0 * i / n, -3, 1);
                           const Id inlay = m.box(lo, {3.0 / n, 6, 1});
                           body = m.unite({m.subtract({body, inlay}), inlay});
                       }
                       return m.seen(body, kEye, {0, 0, 1});
                   }});
}

void add_touching(std::vector<Family>& all) {
    all.push_back(
        {"touching at an edge", "Two cubes share an edge, up to a distance.", "distance / size", gaps(),
         [](double gap) {
             Maker m;
             const Id cubes = m.unite({m.box({-4, -4, 0}, {4, 4, 4}), m.box({4 * gap, 4 * gap, 0}, {4, 4, 4})});
             return m.seen(cubes, kEye, {0, 0, 2});
         }});
    all.push_back(
        {"touching at a vertex", "Two cubes share a vertex, up to a distance.", "distance / size", gaps(),
         [](double gap) {
             Maker m;
             const Id cubes = m.unite({m.box({-4, -4, -4}, {4, 4, 4}), m.box(glm::dvec3(4 * gap), {4, 4, 4})});
             return m.seen(cubes, kEye, {0, 0, 0});
         }});
    all.push_back(
        {"tangent cylinders", "One cylinder cuts another that it only touches.", "distance / radius", gaps(),
         [](double gap) {
             Maker m;
             const Id cut = m.subtract({m.cylinder({-2, 0, 0}, 4, 2, 36), m.cylinder({2 + 2 * gap, 0, -1}, 6, 2, 36)});
             return m.seen(cut, kEye, {0, 0, 2});
         }});
    all.push_back(
        {"tangent spheres", "A sphere within another, touching it.", "distance / radius", gaps(), [](double gap) {
             Maker m;
             const Id cut = m.subtract({m.sphere({0, 0, 0}, 3, 30), m.sphere({1.5 - 3 * gap, 0, 0}, 1.5, 30)});
             return m.seen(cut, {20, -3, 4}, {0, 0, 0});
         }});
}

void add_equal(std::vector<Family>& all) {
    all.push_back({"equal leaves subtracted",
                   "A body less itself, n times, beside a mark.",
                   "times",
                   {1, 2, 4, 8, 16, 32},
                   [](double n) {
                       Maker m;
                       std::vector<Id> same;
                       for (int i = 0; i <= static_cast<int>(n); ++i) {
                           same.push_back(m.sphere({0, 0, 0}, 3, 20));
                       }
                       return m.seen(m.unite({m.subtract(same), m.box({3, -1, -1}, {1, 2, 2})}), kEye, {0, 0, 0});
                   }});
    all.push_back({"a cube less its turned copy",
                   "The same cube by way of a rotation of quarter turns.",
                   "quarter turns",
                   {1, 2, 3, 4, 5, 40, 401},
                   [](double n) {
                       Maker m;
                       const auto cube = [&] { return m.box({-2, -2, -2}, {4, 4, 4}); };
                       const Id none = m.subtract({cube(), m.turn(90 * n, {0, 0, 1}, cube())});
                       return m.seen(m.unite({none, m.box({3, -1, -1}, {1, 2, 2})}), kEye, {0, 0, 0});
                   }});
    all.push_back(
        {"A and not A", "A ∩ (B − A), nested.", "levels", {1, 2, 4, 8, 16, 32}, [](double n) {
             Maker m;
             const auto a = [&] { return m.sphere({0, 0, 0}, 3, 16); };
             Id none = m.intersect({a(), m.subtract({m.box({-4, -4, -4}, {8, 8, 8}), a()})});
             for (int i = 1; i < static_cast<int>(n); ++i) {
                 none = m.intersect({a(), m.subtract({m.unite({none, m.box({-4, -4, -4}, {8, 8, 8})}), a()})});
             }
             return m.seen(m.unite({none, m.box({3, -1, -1}, {1, 2, 2})}), kEye, {0, 0, 0});
         }});
    all.push_back({"cylinders of many and few sides",
                   "A cylinder less one whose corners lie on the same circle.",
                   "sides",
                   {6, 12, 24, 48, 96},
                   [](double sides) {
                       Maker m;
                       const Id rest = m.subtract({m.cylinder({0, 0, 0}, 3, 3, sides), m.cylinder({0, 0, 0}, 3, 3, 6)});
                       return m.seen(rest, kEye, {0, 0, 1});
                   }});
}

}  // namespace

void add_coincident(std::vector<Family>& families) {
    add_shared_faces(families);
    add_touching(families);
    add_equal(families);
}

}  // namespace stability
