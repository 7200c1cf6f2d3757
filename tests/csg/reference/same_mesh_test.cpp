// The same model is the same mesh, wherever in memory it is made.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>

#include "tests/csg/reference/meshes.h"

namespace {

/// Leaves the heap in another state each time, so that addresses come in another order.
class Clutter {
  public:
    explicit Clutter(std::uint32_t seed) {
        std::mt19937 random(seed);
        for (int i = 0; i < 2000; ++i) {
            blocks_.push_back(std::make_unique<char[]>(16 + random() % 600));
        }
        for (std::size_t i = blocks_.size(); i > 1; --i) {
            std::swap(blocks_[i - 1], blocks_[random() % i]);
            if (random() % 2 == 0) {
                blocks_[i - 1].reset();
            }
        }
    }

  private:
    std::vector<std::unique_ptr<char[]>> blocks_;
};

std::string bytes_of(const std::string& program, std::uint32_t seed) {
    const Clutter before(seed);
    const auto model = meshes::model_of(program);
    const Clutter between(seed + 1);
    return ui::encode_mesh(*model, ui::make_mesh(*model), ui::MeshFormat::Off);
}

void expect_same(const std::string& program) {
    const std::string first = bytes_of(program, 0);
    for (std::uint32_t run = 1; run < 10; ++run) {
        ASSERT_EQ(bytes_of(program, 10 * run), first) << program;
    }
}

class SameMesh : public testing::TestWithParam<const char*> {};

TEST_P(SameMesh, TenTimes) {
    expect_same(GetParam());
}

constexpr const char* kPrograms[] = {
    "hull() { sphere(3); translate([5, 0, 0]) sphere(3); }",
    "hull() { cylinder(h = 3, r = 2, $fn = 40); translate([5, 0, 1]) cube(2); }",
    "hull() { linear_extrude(1) text(\"S\"); translate([0, 0, 5]) sphere(2, $fn = 12); }",
    "translate([20, 0, 0]) linear_extrude(3) text(\"I\", size = 5); hull() { sphere(3); translate([5, 0, 0]) "
    "sphere(3); }",
    "minkowski() { cube(3); cylinder(h = 1, r = 1, $fn = 20); }",
    "minkowski() { difference() { cube(3); translate([1, 1, -1]) cube(5); } sphere(1, $fn = 8); }",
    "roof() square([4, 7]);",
    "roof(method = \"straight\") square([4, 7]);",
    "linear_extrude(4, twist = 50) difference() { circle(5); square(3, center = true); }",
    "rotate_extrude() translate([5, 0]) { circle(2); square(2); }",
    "linear_extrude(1) projection() rotate([30, 40, 0]) cube(4);",
    "linear_extrude(1) projection(cut = true) sphere(4);",
    "linear_extrude(2) offset(1) text(\"Ag\");",
    "resize([9, 0, 0], auto = true) difference() { sphere(3); cube(9); }",
    "for (x = [0:3], y = [0:3]) if ((x + y) % 2 == 0) translate([x, y, 0]) cube(1);",
    // Exact arithmetic.
    "difference() { rotate([17.3, 29.1, 41.7]) cube([9999, 0.1, 3]); sphere(1); rotate([3, 4, 5]) cube(2); }",
};

INSTANTIATE_TEST_SUITE_P(Programs, SameMesh, testing::ValuesIn(kPrograms),
                         [](const auto& info) { return "Nr" + std::to_string(info.index); });

TEST(SameMesh, OfTheGalleryAndTheCases) {
    std::size_t count = 0;
    for (const char* folder : {"/models", "/tests/csg/reference/cases"}) {
        for (const auto& entry : std::filesystem::directory_iterator(std::string(CSGSCOPE_SOURCE_DIR) + folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".scad" && extension != ".csg") {
                continue;
            }
            std::ifstream in(entry.path());
            std::stringstream text;
            text << in.rdbuf();
            SCOPED_TRACE(entry.path());
            expect_same(text.str());
            ++count;
        }
    }
    EXPECT_GE(count, 14u);
}

}  // namespace
