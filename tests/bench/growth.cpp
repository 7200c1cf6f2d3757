#include "tests/bench/growth.h"

#include <cmath>
#include <map>
#include <string>

namespace bench {

namespace {

using stability::Case;
using stability::Maker;
using Id = Maker::Id;

const glm::dvec3 kEye(13, -17, 15);

/// n balls in a cube, each touching into its neighbors, less a large one at a corner.
Case sphere_pile(double n) {
    Maker m;
    std::vector<Id> balls;
    const int side = static_cast<int>(std::ceil(std::cbrt(n)));
    const double d = 8.0 / side;
    for (int i = 0; i < static_cast<int>(n); ++i) {
        const int layer = i / side / side;
        const glm::dvec3 at(i % side + (layer % 2 == 0 ? 0.25 : 0.75), i / side % side + 0.5, layer + 0.5);
        balls.push_back(m.sphere(d * at - 4.0, 0.55 * d, 8));
    }
    return m.seen(m.subtract({m.unite(balls), m.sphere({4, -4, 4}, 4, 32)}), kEye, {0, 0, 0});
}

/// n gears in rows, each with twelve teeth and a bore, that mesh with their neighbors.
Case gear_train(double n) {
    constexpr int kTeeth = 12;
    Maker m;
    std::vector<Id> gears;
    const int side = static_cast<int>(std::ceil(std::sqrt(n)));
    const double d = 10.0 / side, r = 0.42 * d;
    for (int i = 0; i < static_cast<int>(n); ++i) {
        const int column = i % side, row = i / side;
        std::vector<Id> body{m.cylinder({0, 0, 0}, 0.3 * d, r, 24)};
        for (int tooth = 0; tooth < kTeeth; ++tooth) {
            const double angle = (tooth + ((column + row) % 2 == 0 ? 0.0 : 0.5)) * 360.0 / kTeeth;
            body.push_back(m.turn(angle, {0, 0, 1}, m.box({0.9 * r, -0.11 * r, 0}, {0.25 * r, 0.22 * r, 0.3 * d})));
        }
        const Id gear = m.subtract({m.unite(body), m.cylinder({0, 0, -1}, 2 + d, 0.3 * r, 16)});
        gears.push_back(m.at({(column + 0.5) * d - 5, (row + 0.5) * d - 5, 0}, gear));
    }
    return m.seen(m.unite(gears), {4, -10, 24}, {0, 0, 0});
}

}  // namespace

std::vector<stability::Family> growing_families() {
    static const std::map<std::string, std::vector<double>> levels{
        {"leaves", {10, 100, 1000, 10000, 100000}},
        {"holes in a plate", {1, 10, 100, 1000, 10000}},
        {"menger", {1, 2, 3, 4, 5}},
        {"intersections under a difference", {1, 4, 16, 64, 256}},
    };
    std::vector<stability::Family> all;
    for (stability::Family& family : stability::families()) {
        if (const auto larger = levels.find(family.name); larger != levels.end()) {
            family.levels = larger->second;
            all.push_back(std::move(family));
        }
    }
    all.push_back(
        {"sphere pile", "n balls that touch, less a large one.", "balls", {10, 100, 1000, 10000, 100000}, sphere_pile});
    all.push_back({"gear train", "n gears with twelve teeth and a bore.", "gears", {1, 7, 70, 700, 7000}, gear_train});
    return all;
}

}  // namespace bench
