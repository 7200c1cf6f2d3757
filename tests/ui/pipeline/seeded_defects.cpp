#include "tests/ui/pipeline/seeded_defects.h"

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <random>

#include <fmt/format.h>

namespace test {

namespace {

/// The same numbers from the same seed everywhere: std's distributions do not promise that.
class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double least, double most) {
        return least + (most - least) * static_cast<double>(engine_() % 1'000'003) / 1'000'003;
    }
    unsigned below(unsigned count) { return static_cast<unsigned>(engine_() % count); }

  private:
    std::mt19937 engine_;
};

using ui::FindingKind;

std::string box_at(double x, double y, double z, double dx, double dy, double dz) {
    return fmt::format("translate([{}, {}, {}]) cube([{}, {}, {}]);", x, y, z, dx, dy, dz);
}

Defect idle(unsigned which) {
    const std::string cutter = box_at(100, 0, 0, 5, 5, 5);
    switch (which % 5) {
        case 0:
            return {FindingKind::NoEffect, "", cutter, -1, {}};
        case 1:  // In the pocket, beside what is left of the box.
            return {FindingKind::NoEffect, "", box_at(8, 8, 8, 4, 4, 2), -1, {}};
        case 2:
            return {FindingKind::NoEffect, "intersection() { cube(4); translate([50, 0, 0]) cube(4); }", "", -1, {}};
        case 3:
            return {FindingKind::NoEffect, box_at(34, -27, 2, 2, 3, 3), "", -1, {FindingKind::Interference}};
        default:
            return {FindingKind::NoEffect, "translate([60, 40, 0]) { cube(6); cube(6); }", "", -1, {}};
    }
}

}  // namespace

std::string seeded_model(unsigned seed, const std::vector<Defect>& defects) {
    Random random(seed);
    std::string cuts, texts;
    for (const Defect& defect : defects) {
        cuts += defect.cut;
        texts += defect.text;
    }
    const double a = random.between(0, 360), b = random.between(0, 360), c = random.between(0, 360);
    return fmt::format(
        "rotate([{:.4f}, {:.4f}, {:.4f}]) {{\n"
        "  difference() {{\n"
        "    cube([40, 30, 12]);\n"
        "    translate([4, 4, 4]) cube([18, 22, 20]);\n"
        "    translate([32, 15, -1]) cylinder(d = {:.3f}, h = 20, $fn = {});\n"
        "    {}\n"
        "  }}\n"
        "  translate([0, 45, 0]) linear_extrude(10) polygon([[0, 0], [20, 0], [0, 12.1]]);\n"
        "  translate([60, 15, 0]) cylinder(r1 = 9, r2 = 2, h = {:.3f}, $fn = 48);\n"
        "  union() {{ translate([30, -30, 0]) cube([10, 10, 8]); translate([35, -25, 0]) sphere(r = 7, $fn = 40); }}\n"
        "  {}\n"
        "}}\n",
        a, b, c, random.between(3, 8), 12 + random.below(60), cuts, random.between(6, 20), texts);
}

std::vector<Defect> defects_of(unsigned seed, double reach) {
    Random random(seed + 1000);
    const double side = 2.02 * reach;  // Of squares that hold the disc.
    std::vector<Defect> defects;

    const double wall = random.between(0.05, 0.95);
    defects.push_back(
        {FindingKind::Wall, "", box_at(22 + wall, random.between(5, 20), 12 - side, 2, side, 5), wall, {}});

    const double gap = random.between(0.05, 0.75);
    defects.push_back({FindingKind::Gap, "", box_at(random.between(6, 18), 6, 4 - side, gap, side, 5), gap, {}});

    const double pin = random.between(0.2, 0.9);
    const int sides = 6 + 2 * static_cast<int>(random.below(20));
    const bool hole = random.below(2) != 0;
    const std::string body = fmt::format("translate([{}, 15, 2]) cylinder(d = {}, h = {}, $fn = {});", hole ? 26 : 8,
                                         pin, hole ? 12 : 5, sides);
    const double flat = pin * std::cos(std::numbers::pi / sides);
    defects.push_back(
        hole ? Defect{FindingKind::Feature, "", body, flat, {FindingKind::Gap}}
             : Defect{FindingKind::Feature, body, "", flat, {FindingKind::Wall, FindingKind::Interference}});

    const double deep = random.between(0.01, 1.5);
    defects.push_back({FindingKind::Interference, box_at(8, 8, deep - 6, side, side, 6), "", deep, {}});

    // The nearest of two bodies are two edges, two faces, or a corner and a face.
    const double apart = random.between(0.05, 1.4);
    const unsigned nearest = random.below(3);
    const std::string other =
        nearest == 0 ? box_at(8, 8, -6 - apart, 5, 5, 6)
        : nearest == 1
            ? fmt::format("translate([20, 10, {}]) rotate([45, 0, 20]) cube([6, 6, 6]);",
                          -6 * std::numbers::sqrt2 - apart)
            : fmt::format("translate([20, 10, {}]) rotate([0, 180, 0]) cylinder(r1 = 0, r2 = 4, h = 5, $fn = 4);",
                          -apart);
    defects.push_back({FindingKind::Clearance, other, "", apart, {FindingKind::Gap}});

    defects.push_back(idle(seed));
    defects.push_back(idle(seed + 2));

    defects.push_back(random.below(2) == 0
                          ? Defect{FindingKind::Coincident, box_at(8, 8, -5, side, side, 5), "", -1, {}}
                          : Defect{FindingKind::Coincident, "", box_at(30, 2, 12 - 3, side, side, 3), -1, {}});
    return defects;
}

}  // namespace test
