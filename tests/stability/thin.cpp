// Walls, shells and triangles that get thin.
#include <cmath>
#include <numbers>

#include "tests/stability/family.h"

namespace stability {

namespace {
using Id = Maker::Id;
}

void add_thin(std::vector<Family>& all) {
    all.push_back({"nested shells",
                   "n shells within each other, each half as thick as the one outside.",
                   "shells",
                   {1, 2, 4, 8, 12, 16},
                   [](double n) {
                       Maker m;
                       std::vector<Id> shells;
                       double radius = 4, thickness = 1;
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           shells.push_back(m.subtract(
                               {m.sphere({0, 0, 0}, radius, 20), m.sphere({0, 0, 0}, radius - thickness, 20)}));
                           radius -= 1.5 * thickness;
                           thickness /= 2;
                       }
                       const Id cut = m.subtract({m.unite(shells), m.box({0, -5, 0}, {5, 5, 5})});
                       return m.seen(cut, {13, -17, 15}, {0, 0, 0});
                   }});
    all.push_back({"walls below a pixel",
                   "Fins of this thickness, seen from above.",
                   "thickness / pixel",
                   {4, 1, 0.3, 0.1, 0.01, 1e-4},
                   [](double pixels) {
                       Maker m;
                       std::vector<Id> fins{m.box({-4, -4, -1}, {8, 8, 1})};
                       for (int i = 0; i < 10; ++i) {
                           fins.push_back(m.box({-3.7 + 0.77 * i, -3, 0}, {0.25 * pixels, 6, 2}));
                       }
                       return m.seen(m.unite(fins), {3, -7, 22}, {0, 0, 0});
                   }});
    all.push_back({"slots below a pixel",
                   "Slots of this width cut through a plate.",
                   "width / pixel",
                   {4, 1, 0.3, 0.1, 0.01, 1e-4},
                   [](double pixels) {
                       Maker m;
                       std::vector<Id> plate{m.box({-4, -4, -1}, {8, 8, 1})};
                       for (int i = 0; i < 10; ++i) {
                           plate.push_back(m.box({-3.7 + 0.77 * i, -3, -1}, {0.25 * pixels, 6, 1}));
                       }
                       return m.seen(m.subtract(plate), {3, -7, 22}, {0, 0, 0});
                   }});
    all.push_back({"needles",
                   "Pyramids this many times as high as wide.",
                   "height / width",
                   {1, 10, 100, 1e3, 1e4, 1e6, 1e8},
                   [](double ratio) {
                       Maker m;
                       std::vector<Id> needles;
                       const double width = 8 / ratio;
                       for (int i = 0; i < 6; ++i) {
                           const double x = -4 + 1.5 * i;
                           needles.push_back(m.mesh({{x, 0, 0}, {x + width, 0, 0}, {x, width, 0}, {x + 0.3, 0.2, 8}},
                                                    {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}));
                       }
                       needles.push_back(m.box({-4, 1, 0}, {8, 1, 4}));
                       return m.seen(m.unite(needles), {5, -25, 9}, {0, 0, 4});
                   }});
    all.push_back(
        {"slivers", "A drilled cylinder with this many sides.", "sides", {8, 32, 128, 512, 2048}, [](double sides) {
             Maker m;
             const Id tube = m.subtract({m.cylinder({0, 0, 0}, 4, 4, sides), m.cylinder({0, 0, -1}, 6, 3, sides)});
             return m.seen(tube, {13, -17, 15}, {0, 0, 2});
         }});
    all.push_back({"grazing planes",
                   "A plate seen under this angle.",
                   "angle in degrees",
                   {30, 3, 0.3, 0.03, 1e-3, 1e-5, 1e-8},
                   [](double degrees) {
                       Maker m;
                       const Id plate = m.subtract({m.box({-4, -4, -1}, {8, 8, 1}), m.box({-2, -2, -0.5}, {4, 4, 1}),
                                                    m.cylinder({3, 0, -2}, 4, 0.5)});
                       const double a = degrees * std::numbers::pi / 180;
                       return m.seen(plate, {0.123, -24 * std::cos(a), 24 * std::sin(a)}, {0, 0, 0});
                   }});
    all.push_back({"faces seen edge-on",
                   "A view along the faces, but for this angle.",
                   "angle in degrees",
                   {1, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 0},
                   [](double degrees) {
                       Maker m;
                       const Id body = m.subtract({m.box({-4, -4, -4}, {8, 8, 8}), m.box({-2, -5, 0}, {4, 10, 5}),
                                                   m.box({-5, -2, 2}, {10, 4, 3})});
                       const double a = degrees * std::numbers::pi / 180;
                       return m.seen(body, {24 * std::sin(a), -24 * std::cos(a), 24 * std::sin(a)}, {0, 0, 0});
                   }});
    all.push_back({"sharp wedges",
                   "A wedge of this angle subtracted from a block.",
                   "angle in degrees",
                   {45, 10, 1, 0.1, 1e-3, 1e-6},
                   [](double degrees) {
                       Maker m;
                       const double h = 8 * std::tan(degrees * std::numbers::pi / 180);
                       const Id wedge = m.mesh({{-4, -5, 0}, {4, -5, h}, {4, -5, 0}, {-4, 5, 0}, {4, 5, h}, {4, 5, 0}},
                                               {{0, 1, 2}, {5, 4, 3}, {0, 2, 5, 3}, {2, 1, 4, 5}, {1, 0, 3, 4}});
                       return m.seen(m.subtract({m.box({-4, -4, -4}, {8, 8, 8}), wedge}), {17, -13, 9}, {0, 0, 0});
                   }});
}

}  // namespace stability
