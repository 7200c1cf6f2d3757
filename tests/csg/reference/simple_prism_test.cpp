// Whether prisms meet themselves, by their outlines.
#include "csg/reference/simple_prism.h"

#include <gtest/gtest.h>

#include "tests/csg/reference/meshes.h"

namespace {

using csg::reference::Mesh;

/// Of a loop with a fan for its caps.
Mesh prism(const std::vector<glm::dvec2>& loop) {
    const auto n = static_cast<std::uint32_t>(loop.size());
    Mesh mesh;
    for (const double z : {0.0, 1.0}) {
        for (const glm::dvec2& p : loop) {
            mesh.points.emplace_back(p, z);
        }
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        if (i > 0 && j > 0) {
            mesh.triangles.emplace_back(0, j, i);
            mesh.triangles.emplace_back(n, n + i, n + j);
        }
        mesh.triangles.emplace_back(i, j, n + j);
        mesh.triangles.emplace_back(i, n + j, n + i);
    }
    mesh.sources.assign(mesh.triangles.size(), 0);
    return mesh;
}

Mesh mesh_of(const std::string& program) {
    return ui::make_mesh(*meshes::model_of(program)).mesh;
}

TEST(SimplePrism, IsToldByItsOutline) {
    EXPECT_EQ(csg::reference::prism_meets_itself(prism({{0, 0}, {4, 0}, {4, 1}, {1, 1}})), false);
    // Around a turn and a half, so that every triangle of the fan faces up and sides cross.
    EXPECT_EQ(csg::reference::prism_meets_itself(prism({{0, 0}, {4, 0}, {4, 4}, {-4, 4}, {-4, -4}, {3, -4}, {2, 2}})),
              true);
}

TEST(SimplePrism, AlongAnyAxisWithHoles) {
    const std::string comb =
        "linear_extrude(3) difference() { square([60, 5]); for (i = [0 : 19]) translate([3 * i + 1, 2]) square([1, "
        "5]); "
        "translate([1, .5]) square([50, 1]); }";
    for (const char* turned : {"", "rotate([90, 0, 0]) ", "rotate([0, 90, 0]) "}) {
        EXPECT_EQ(csg::reference::prism_meets_itself(mesh_of(turned + comb)), false) << turned;
    }
}

TEST(SimplePrism, OthersAreNone) {
    EXPECT_FALSE(csg::reference::prism_meets_itself(mesh_of("rotate([10, 20, 30]) cube(4);")).has_value());
    EXPECT_FALSE(csg::reference::prism_meets_itself(mesh_of("cylinder(h = 4, r1 = 2, r2 = 1);")).has_value());
    EXPECT_FALSE(csg::reference::prism_meets_itself(mesh_of("sphere(4);")).has_value());
}

}  // namespace
