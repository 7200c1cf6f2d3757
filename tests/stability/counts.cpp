// Many leaves, deep nesting, and expressions whose sums of products explode.
#include <cmath>

#include "tests/stability/family.h"

namespace stability {

namespace {
using Id = Maker::Id;
const glm::dvec3 kEye(13, -17, 15);
/// The prisms through a cube of side 8 that make it a Menger sponge of so many levels.
void menger_holes(Maker& m, int levels, std::vector<Id>& cuts) {
    for (int level = 1, cells = 1; level <= levels; ++level, cells *= 3) {
        const double cell = 8.0 / cells, hole = cell / 3;
        for (int i = 0; i < cells * cells; ++i) {
            // Cells that a larger hole has taken away need none.
            bool gone = false;
            for (int u = i % cells, v = i / cells; u > 0 || v > 0; u /= 3, v /= 3) {
                gone = gone || (u % 3 == 1 && v % 3 == 1);
            }
            if (gone) {
                continue;
            }
            const double u = -4 + cell * (i % cells) + hole, v = -4 + cell * (i / cells) + hole;
            cuts.push_back(m.box({u, v, -4}, {hole, hole, 8}));
            cuts.push_back(m.box({u, -4, v}, {hole, 8, hole}));
            cuts.push_back(m.box({-4, u, v}, {8, hole, hole}));
        }
    }
}

}  // namespace

void add_counts(std::vector<Family>& all) {
    all.push_back(
        {"depth complexity", "n plates behind each other.", "plates", {1, 10, 50, 100, 250, 500}, [](double n) {
             Maker m;
             std::vector<Id> plates;
             for (int i = 0; i < static_cast<int>(n); ++i) {
                 plates.push_back(m.box({-4, -4, 8 * i / n}, {8, 8, 4 / n}));
             }
             return m.seen(m.subtract({m.unite(plates), m.cylinder({1, 0, -1}, 10, 1)}), {1, -3, 30}, {0, 0, 4});
         }});
    all.push_back({"nesting", "Difference in difference, n deep.", "depth", {1, 10, 100, 1000, 10000}, [](double n) {
                       Maker m;
                       Id body = m.box({-4, -4, -4}, {8, 8, 8});
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           const double a = 2.399963 * i, r = 3.8 * std::sqrt((i + 0.5) / n);
                           const Id ball = m.sphere({r * std::cos(a), r * std::sin(a), 4}, 0.3, 8);
                           body = i % 2 == 0 ? m.subtract({body, ball}) : m.unite({body, ball});
                       }
                       return m.seen(body, kEye, {0, 0, 0});
                   }});
    all.push_back(
        {"leaves", "So many cubes and balls in a grid.", "leaves", {10, 100, 1000, 10000, 100000}, [](double n) {
             Maker m;
             std::vector<Id> cells;
             const int side = static_cast<int>(std::ceil(std::cbrt(n)));
             const double d = 8.0 / side;
             for (int i = 0; i < static_cast<int>(n); ++i) {
                 const glm::dvec3 at = d * glm::dvec3(i % side, i / side % side, i / side / side) - 4.0;
                 cells.push_back(m.box(at, glm::dvec3(0.6 * d)));
             }
             return m.seen(m.unite(cells), kEye, {0, 0, 0});
         }});
    all.push_back({"holes in a plate", "A plate with n holes.", "holes", {1, 4, 16, 64, 256, 1024}, [](double n) {
                       Maker m;
                       std::vector<Id> plate{m.box({-4, -4, -1}, {8, 8, 1})};
                       const int side = static_cast<int>(std::ceil(std::sqrt(n)));
                       const double d = 8.0 / side;
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           plate.push_back(
                               m.cylinder({-4 + d * (i % side + 0.5), -4 + d * (i / side + 0.5), -2}, 3, 0.35 * d, 12));
                       }
                       return m.seen(m.subtract(plate), {3, -7, 22}, {0, 0, 0});
                   }});
    all.push_back(
        {"intersections under a difference",
         "A box less n × (sphere ∩ cylinder): 2ⁿ products.",
         "n",
         {1, 2, 4, 8, 12, 16},
         [](double n) {
             Maker m;
             std::vector<Id> body{m.box({-4, -4, -4}, {8, 8, 8})};
             for (int i = 0; i < static_cast<int>(n); ++i) {
                 const double a = 6.283 * i / n;
                 const glm::dvec3 p(2.5 * std::cos(a), 2.5 * std::sin(a), 3);
                 body.push_back(m.intersect({m.sphere(p, 2, 12), m.cylinder(p - glm::dvec3(0, 0, 3), 6, 1.5, 12)}));
             }
             return m.seen(m.subtract(body), {8, -12, 20}, {0, 0, 0});
         }});
    all.push_back({"unions under an intersection",
                   "n unions of two overlapping balls, intersected.",
                   "n",
                   {1, 2, 4, 8, 16, 32},
                   [](double n) {
                       Maker m;
                       std::vector<Id> factors{m.box({-4, -4, -4}, {8, 8, 8})};
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           const double a = 3.1416 * i / n;
                           const glm::dvec3 p(std::cos(a), std::sin(a), 0.3);
                           factors.push_back(m.unite({m.sphere(p, 3, 12), m.sphere(-p, 3, 12)}));
                       }
                       return m.seen(m.intersect(factors), kEye, {0, 0, 0});
                   }});
    all.push_back(
        {"alternation", "Difference, union and intersection in turn.", "levels", {1, 5, 10, 20, 35, 50}, [](double n) {
             Maker m;
             Id body = m.box({-4, -4, -4}, {8, 8, 8});
             for (int i = 0; i < static_cast<int>(n); ++i) {
                 const double a = 2.4 * i;
                 const Id ball =
                     m.sphere({3 * std::cos(a), 3 * std::sin(a), 2 * std::sin(1.7 * a)}, 1.5 + 0.02 * i, 12);
                 const Id cut = m.subtract({m.box({-5, -5, -5}, {10, 10, 10}), ball});
                 body = i % 3 == 0   ? m.subtract({body, ball})
                        : i % 3 == 1 ? m.unite({body, ball})
                                     : m.intersect({body, m.unite({cut, ball})});
             }
             return m.seen(body, kEye, {0, 0, 0});
         }});
    all.push_back(
        {"menger", "A Menger sponge: a cube less prisms with common planes.", "levels", {1, 2, 3}, [](double n) {
             Maker m;
             std::vector<Id> sponge{m.box({-4, -4, -4}, {8, 8, 8})};
             menger_holes(m, static_cast<int>(n), sponge);
             return m.seen(m.subtract(sponge), kEye, {0, 0, 0});
         }});
    all.push_back({"spheres", "n balls that overlap, less n smaller ones.", "balls", {1, 4, 16, 64, 256}, [](double n) {
                       Maker m;
                       std::vector<Id> balls, cuts;
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           const double a = 2.399963 * i, r = 3 * std::sqrt((i + 0.5) / n);
                           const glm::dvec3 p(r * std::cos(a), r * std::sin(a), std::sin(3 * a));
                           balls.push_back(m.sphere(p, 1, 12));
                           cuts.push_back(m.sphere(p + glm::dvec3(0.1, -0.2, 0.8), 0.6, 12));
                       }
                       return m.seen(m.subtract({m.unite(balls), m.unite(cuts)}), kEye, {0, 0, 0}, 22);
                   }});
}

}  // namespace stability
