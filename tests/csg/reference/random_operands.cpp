#include "tests/csg/reference/random_operands.h"

#include <fmt/format.h>

namespace random_operands {
namespace {

class Maker {
  public:
    explicit Maker(std::mt19937_64& random) : random_(random) {}

    std::string convex() {
        switch (below(7)) {
            case 0:
                return placed("cube(" + size() + ");");
            case 1:
                return placed(fmt::format("sphere({}, $fn = {});", 1 + below(3), 4 + below(9)));
            case 2:
                return placed(fmt::format("cylinder(h = {}, r1 = {}, r2 = {}, $fn = {});", 1 + below(3), 1 + below(3),
                                          below(3), 3 + below(9)));
            case 3:
                return fmt::format("hull() {{ {} {} }}", convex_part(), convex_part());
            case 4:
                return placed(fmt::format("cylinder(h = 1e-{}, r = 1, $fn = {});", 3 + below(5), 3 + below(9)));
            case 5:
                return "cube(" + size() + ");";
            default:
                return fmt::format("translate({}) cube({}, center = true);", position(), size());
        }
    }

    std::string general() {
        switch (below(10)) {
            case 0:
                return boxes("union", 2 + below(4));
            case 1:
                return boxes("difference", 2 + below(4));
            case 2:
                return placed(fmt::format(
                    "linear_extrude({}) difference() {{ square({}); translate([{}, {}]) circle({}, $fn = {}); }}",
                    1 + below(3), 4 + below(3), 2 + below(3), 2 + below(3), 1 + below(2), 3 + below(9)));
            case 3:
                return placed(
                    fmt::format("linear_extrude({}) polygon([[0, 0], [{}, 0], [{}, 1], [1, 1], [1, {}], [0, {}]]);",
                                1 + below(3), 2 + below(3), 2 + below(3), 2 + below(3), 2 + below(3)));
            case 4:
                return placed(
                    fmt::format("rotate_extrude(angle = {}, $fn = {}) polygon([[{}, 0], [4, 0], [3, 1], [4, "
                                "3], [{}, 2]]);",
                                below(2) == 0 ? 360 : 60 + 30 * below(9), 5 + below(8), below(3), below(3)));
            case 5:
                return placed(fmt::format("rotate_extrude($fn = {}) translate([{}, 0]) circle(1, $fn = {});",
                                          4 + below(9), 1 + below(4), 3 + below(6)));
            case 6:
                return placed(fmt::format(
                    "linear_extrude({}, twist = {}, slices = {}) translate([{}, 0]) square([2, 1], center = true);",
                    2 + below(3), 30 * below(12), 2 + below(4), below(3)));
            case 7:
                return placed(fmt::format("difference() {{ cube(6, center = true); {} }}", cavity()));
            case 8:
                return placed(
                    fmt::format("difference() {{ cube([5, 4, {}]); translate([1, 1, -1]) cube([2, {}, 9]); }}",
                                below(2) == 0 ? "0.001" : "0.25", 1 + below(3)));
            default:
                return overlapping_shells();
        }
    }

  private:
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    std::string size() { return fmt::format("[{}, {}, {}]", 1 + below(4), 1 + below(4), 1 + below(4)); }
    std::string position() { return fmt::format("[{}, {}, {}]", below(5) - 2, below(5) - 2, below(5) - 2); }
    std::string placed(const std::string& object) {
        switch (below(4)) {
            case 0:
                return fmt::format("rotate([{}, {}, {}]) {}", below(360), below(360), below(360), object);
            case 1:
                return fmt::format("rotate([{}, 0, {}]) {}", 90 * below(4), 45 * below(8), object);
            default:
                return object;
        }
    }
    std::string convex_part() {
        return fmt::format("translate({}) {}", position(),
                           below(2) == 0 ? "cube(" + size() + ");" : "sphere(1, $fn = 5);");
    }
    std::string boxes(const char* operation, int count) {
        std::string text = std::string(operation) + "() {";
        if (operation[0] == 'd') {
            text += " cube(4, center = true);";
        }
        for (int i = 0; i < count; ++i) {
            const char* turn = below(4) == 0 ? "rotate([10, 20, 30]) " : "";
            text += fmt::format(" translate({}) {}cube({});", position(), turn, size());
        }
        return text + " }";
    }
    std::string cavity() {
        return below(2) == 0 ? fmt::format("cube({}, center = true);", 2 + below(3))
                             : fmt::format("sphere(2, $fn = {});", 4 + below(5));
    }
    /// Two boxes as one polyhedron.
    std::string overlapping_shells() {
        std::string points, faces;
        for (int box = 0; box < 2; ++box) {
            const int x = below(4), y = below(4), z = below(4), size = 2 + below(3);
            for (int i = 0; i < 8; ++i) {
                points +=
                    fmt::format("[{}, {}, {}], ", x + size * (i & 1), y + size * (i >> 1 & 1), z + size * (i >> 2));
            }
            constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                          {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
            for (const auto& f : kFaces) {
                faces +=
                    fmt::format("[{}, {}, {}, {}], ", f[0] + 8 * box, f[1] + 8 * box, f[2] + 8 * box, f[3] + 8 * box);
            }
        }
        return fmt::format("polyhedron([{}], [{}]);", points, faces);
    }

    std::mt19937_64& random_;
};

}  // namespace

std::string convex(std::mt19937_64& random) {
    return Maker(random).convex();
}

std::string general(std::mt19937_64& random) {
    return Maker(random).general();
}

}  // namespace random_operands
