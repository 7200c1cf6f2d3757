#include "csg/solid/solid.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>

#include "csg/solid/extrude.h"
#include "csg/solid/placed.h"
#include "tests/csg/solid/mesh_volume.h"
#include "tests/random/random_tree.h"

namespace {

using csg::Fineness;
using csg::solid::make_solid;
using csg::solid::Solid;
using test::mesh_volume;

/// Every directed edge is there as often as its opposite.
bool closed(std::span<const glm::uvec3> triangles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const glm::uvec3& t : triangles) {
        for (int i = 0; i < 3; ++i) {
            ++edges[{t[i], t[(i + 1) % 3]}];
        }
    }
    return std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
        const auto opposite = edges.find({e.first.second, e.first.first});
        return opposite != edges.end() && opposite->second == e.second;
    });
}

/// Vertices of a file that OpenSCAD 2021.01 wrote.
std::vector<glm::dvec3> golden(const std::string& name) {
    std::ifstream file(std::string(CSGSCOPE_SOURCE_DIR) + "/tests/csg/solid/golden/" + name + ".off");
    std::string off;
    std::size_t count = 0, faces = 0, edges = 0;
    file >> off >> count >> faces >> edges;
    EXPECT_TRUE(file && off == "OFF") << name;
    std::vector<glm::dvec3> points(count);
    for (glm::dvec3& p : points) {
        file >> p.x >> p.y >> p.z;
    }
    EXPECT_TRUE(file) << name;
    return points;
}

TEST(Solid, VerticesAreOpenScads) {
    const Fineness standard;
    const std::pair<const char*, csg::LeafShape> shapes[]{
        {"sphere_7", csg::Sphere{3, {7, 12, 2}}},
        {"sphere_8", csg::Sphere{3, {8, 12, 2}}},
        {"sphere_default", csg::Sphere{5, standard}},
        {"cylinder_6", csg::Cylinder{4, 2, 1, true, {6, 12, 2}}},
        {"cone_up", csg::Cylinder{4, 1.5, 0, false, {5, 12, 2}}},
        {"cone_down", csg::Cylinder{4, 0, 1.5, false, {5, 12, 2}}},
        {"cylinder_fine", csg::Cylinder{2, 4, 4, false, {0, 20, 0.5}}},
        {"cube_centered", csg::Cube{{1, 2, 3}, true}}};
    for (const auto& [name, shape] : shapes) {
        const auto solid = make_solid(shape);
        const std::vector<glm::dvec3> expected = golden(name);
        ASSERT_EQ(solid->points.size(), expected.size()) << name;
        for (const glm::dvec3& p : expected) {
            EXPECT_TRUE(std::any_of(solid->points.begin(), solid->points.end(), [&](const glm::dvec3& q) {
                return glm::length(p - q) < 2e-5;
            })) << fmt::format("{} lacks {}, {}, {}", name, p.x, p.y, p.z);
        }
    }
}

TEST(Solid, SegmentsOfACircleAreOpenScads) {
    const struct {
        double radius;
        Fineness fineness;
        int segments;
    } table[]{
        {0.01, {0, 12, 2}, 5},     {0.01, {0, 12, 0.1}, 5},    {0.01, {0, 5, 1}, 5},       {0.01, {0, 0.5, 0.01}, 7},
        {0.01, {0, 60, 50}, 5},    {0.01, {0, 7, 0.3}, 5},     {0.5, {0, 12, 2}, 5},       {0.5, {0, 12, 0.1}, 30},
        {0.5, {0, 5, 1}, 5},       {0.5, {0, 0.5, 0.01}, 315}, {0.5, {0, 60, 50}, 5},      {0.5, {0, 7, 0.3}, 11},
        {1, {0, 12, 2}, 5},        {1, {0, 12, 0.1}, 30},      {1, {0, 5, 1}, 7},          {1, {0, 0.5, 0.01}, 629},
        {1, {1, 12, 2}, 3},        {1, {2, 12, 2}, 3},         {1, {3, 12, 2}, 3},         {1, {3.7, 12, 2}, 3},
        {1, {100, 12, 2}, 100},    {1, {0, 60, 50}, 5},        {1, {0, 7, 0.3}, 21},       {2, {0, 12, 2}, 7},
        {2, {0, 12, 0.1}, 30},     {2, {0, 5, 1}, 13},         {2, {0, 0.5, 0.01}, 720},   {2, {0, 60, 50}, 5},
        {2, {0, 7, 0.3}, 42},      {5, {0, 12, 2}, 16},        {5, {0, 12, 0.1}, 30},      {5, {0, 5, 1}, 32},
        {5, {0, 0.5, 0.01}, 720},  {5, {0, 60, 50}, 5},        {5, {0, 7, 0.3}, 52},       {7.5, {0, 12, 2}, 24},
        {7.5, {0, 12, 0.1}, 30},   {7.5, {0, 5, 1}, 48},       {7.5, {0, 0.5, 0.01}, 720}, {7.5, {0, 60, 50}, 5},
        {7.5, {0, 7, 0.3}, 52},    {25, {0, 12, 2}, 30},       {25, {0, 12, 0.1}, 30},     {25, {0, 5, 1}, 72},
        {25, {0, 0.5, 0.01}, 720}, {25, {0, 60, 50}, 5},       {25, {0, 7, 0.3}, 52}};
    for (const auto& row : table) {
        EXPECT_EQ(csg::solid::circle_segments(row.radius, row.fineness), row.segments) << fmt::format(
            "r = {}, $fn = {}, $fa = {}, $fs = {}", row.radius, row.fineness.fn, row.fineness.fa, row.fineness.fs);
    }
}

TEST(Solid, SegmentsByErrorStayAsNearToTheCircle) {
    for (const double r : {0.5, 5.0, 300.0}) {
        for (const double error : {0.05, 0.003, 0.0004}) {
            const int n = csg::solid::circle_segments(r, {0, 12, 2, error});
            const auto off = [r](int segments) { return r - r * std::cos(std::numbers::pi / segments); };
            EXPECT_LE(off(n), error) << n;
            EXPECT_GT(off(n - 1), error) << "fewer would do than " << n;
        }
    }
    EXPECT_EQ(csg::solid::circle_segments(1, {0, 12, 2, 100}), 5) << "five at least";
    EXPECT_EQ(csg::solid::circle_segments(1, {0, 12, 2, 1e-5}), 629) << "no more than the least $fs gives";
    EXPECT_EQ(csg::solid::circle_segments(1, {40, 12, 2, 0.1}), 40) << "$fn counts above it";
    EXPECT_EQ(csg::solid::circle_segments(5, {0, 12, 2, 0}), 16) << "0 leaves it to $fa and $fs";
}

TEST(Solid, SegmentsAreBoundedForAnyInput) {
    const double nan = std::nan(""), infinity = HUGE_VAL;
    for (const double r : {0.0, -1.0, 1e-300, 1e300, nan, infinity}) {
        for (const double f : {0.0, -5.0, 1e-300, 1e300, nan, infinity}) {
            EXPECT_GE(csg::solid::circle_segments(r, {f, 12, 2}), 3);
            EXPECT_LE(csg::solid::circle_segments(r, {f, f, f}), 1 << 20);
            EXPECT_GE(csg::solid::circle_segments(r, {0, 12, 2, f}), 3);
            EXPECT_LE(csg::solid::circle_segments(r, {0, 12, 2, f}), 1 << 20);
        }
    }
}

TEST(Solid, ShapesAreClosedConvexAndOfTheRightVolume) {
    for (int n = 3; n <= 40; ++n) {
        const Fineness fineness{static_cast<double>(n), 12, 2};
        // Area of the regular polygon in the unit circle.
        const double area = n * std::sin(2 * M_PI / n) / 2;
        const std::pair<csg::LeafShape, double> shapes[]{{csg::Cylinder{5, 2, 2, n % 2 == 0, fineness}, 20 * area},
                                                         {csg::Cylinder{3, 2, 1, false, fineness}, 7 * area},
                                                         {csg::Cylinder{3, 2, 0, true, fineness}, 4 * area},
                                                         {csg::Cylinder{3, 0, 2, false, fineness}, 4 * area},
                                                         {csg::Sphere{1, fineness}, -1},
                                                         {csg::Cube{{1, 2, static_cast<double>(n)}, false}, 2.0 * n}};
        for (const auto& [shape, expected] : shapes) {
            const auto solid = make_solid(shape);
            EXPECT_TRUE(solid->closed && solid->convex && solid->warnings.empty());
            EXPECT_TRUE(closed(solid->triangles));
            const double v = mesh_volume(solid->points, solid->triangles);
            if (expected > 0) {
                EXPECT_NEAR(v, expected, 1e-12 * expected);
            } else {
                EXPECT_TRUE(v > 0.2 && v < 4 * M_PI / 3);
            }
            csg::Box box;
            for (const glm::dvec3& p : solid->points) {
                box = csg::enclose(box, p);
            }
            EXPECT_EQ(box, solid->box);
        }
    }
    const double ball = mesh_volume(make_solid(csg::Sphere{1, {200, 12, 2}})->points,
                                    make_solid(csg::Sphere{1, {200, 12, 2}})->triangles);
    EXPECT_NEAR(ball, 4 * M_PI / 3, 3e-3);
}

TEST(Solid, ShapesWithoutVolumeHaveNoTriangles) {
    const double nan = std::nan("");
    for (const csg::LeafShape& shape : std::initializer_list<csg::LeafShape>{
             csg::Cube{{1, 0, 1}, false}, csg::Cube{{1, -2, 1}, true}, csg::Cube{{1, nan, 1}, true}, csg::Sphere{0, {}},
             csg::Sphere{-1, {}}, csg::Sphere{HUGE_VAL, {}}, csg::Cylinder{0, 1, 1, false, {}},
             csg::Cylinder{1, 0, 0, false, {}}, csg::Cylinder{1, -1, 1, false, {}}, csg::Cylinder{nan, 1, 1, false, {}},
             std::make_shared<const csg::Polyhedron>()}) {
        EXPECT_TRUE(make_solid(shape)->triangles.empty());
    }
}

csg::Polyhedron tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}, 1};
}

Solid solid_of(const csg::Polyhedron& p) {
    return *make_solid(std::make_shared<const csg::Polyhedron>(p));
}

TEST(Solid, PolyhedraAreCheckedNotBelieved) {
    EXPECT_NEAR(mesh_volume(solid_of(tetrahedron()).points, solid_of(tetrahedron()).triangles), 1.0 / 6, 1e-15);
    EXPECT_TRUE(solid_of(tetrahedron()).closed && solid_of(tetrahedron()).convex);
    EXPECT_TRUE(solid_of(tetrahedron()).warnings.empty());

    csg::Polyhedron open = tetrahedron();
    open.faces.pop_back();
    EXPECT_FALSE(solid_of(open).closed || solid_of(open).convex);
    EXPECT_FALSE(solid_of(open).warnings.empty());

    csg::Polyhedron inside_out = tetrahedron();
    for (auto& face : inside_out.faces) {
        std::reverse(face.begin(), face.end());
    }
    EXPECT_TRUE(solid_of(inside_out).closed);
    EXPECT_FALSE(solid_of(inside_out).convex);
    EXPECT_TRUE(solid_of(inside_out).warnings.empty());  // The same solid, as in OpenSCAD.

    // Points that are given twice are one.
    csg::Polyhedron doubled;
    for (const auto& face : tetrahedron().faces) {
        doubled.faces.emplace_back();
        for (const std::uint32_t i : face) {
            doubled.faces.back().push_back(static_cast<std::uint32_t>(doubled.points.size()));
            doubled.points.push_back(tetrahedron().points[i]);
        }
    }
    EXPECT_TRUE(solid_of(doubled).closed);

    csg::Polyhedron wild = tetrahedron();
    wild.faces.push_back({0, 1, 99});
    wild.faces.push_back({0});
    wild.faces.push_back({});
    EXPECT_NO_THROW(static_cast<void>(solid_of(wild)));
    EXPECT_FALSE(solid_of(wild).failures.empty());
}

/// Two of `a`, the second moved.
csg::Polyhedron two_shells(const csg::Polyhedron& a, const glm::dvec3& by) {
    csg::Polyhedron both = a;
    for (const glm::dvec3& p : a.points) {
        both.points.push_back(p + by);
    }
    for (std::vector<std::uint32_t> face : a.faces) {
        for (std::uint32_t& i : face) {
            i += static_cast<std::uint32_t>(a.points.size());
        }
        both.faces.push_back(face);
    }
    return both;
}

TEST(Solid, ConvexIsOneSheet) {
    // Apart, overlapping, within rounding of each other, the same, sharing an edge.
    for (const glm::dvec3& by :
         {glm::dvec3(3, 0, 0), glm::dvec3(0.1), glm::dvec3(1e-16), glm::dvec3(0.0), glm::dvec3(-1, 1, 0)}) {
        const Solid both = solid_of(two_shells(tetrahedron(), by));
        EXPECT_TRUE(both.closed && both.warnings.empty()) << by.x;
        EXPECT_FALSE(both.convex || both.simple) << by.x;
        EXPECT_TRUE(both.winds()) << by.x;
    }
    EXPECT_FALSE(solid_of(tetrahedron()).winds());
}

TEST(Solid, WhatIsMadeSimpleIsKnownToBe) {
    EXPECT_FALSE(make_solid(csg::Sphere{2, {}})->winds());
    const csg::solid::Outline square{{{{1, 0}, {2, 0}, {2, 1}, {1, 1}}}};
    csg::LinearExtrude how;
    how.height = 3;
    EXPECT_FALSE(csg::solid::linear_extrude(square, how)->winds());
    how.scale = {0.5, 0.5};
    EXPECT_FALSE(csg::solid::linear_extrude(square, how)->winds());
    how.scale = {0.5, 2};
    EXPECT_TRUE(csg::solid::linear_extrude(square, how)->winds());
    how.scale = {1, 1};
    how.twist = 90;
    EXPECT_TRUE(csg::solid::linear_extrude(square, how)->winds());
    EXPECT_FALSE(csg::solid::rotate_extrude(square, {})->winds());
}

TEST(Solid, GapsThatNoPictureShowsAreClosed) {
    csg::Polyhedron apart = tetrahedron();
    // The first face has a corner of its own, a little off.
    apart.points.push_back(apart.points[apart.faces[0][0]] + glm::dvec3(1e-13, 0, -1e-13));
    apart.faces[0][0] = static_cast<std::uint32_t>(apart.points.size() - 1);
    EXPECT_TRUE(solid_of(apart).closed);
    EXPECT_TRUE(solid_of(apart).warnings.empty());
    apart.points.back().x += 1e-6;
    EXPECT_FALSE(solid_of(apart).closed);
    EXPECT_EQ(solid_of(apart).warnings.size(), 1u);
}

/// Random placed polyhedra keep orientation, closedness and volume up to the determinant, mirrored or not.
TEST(Placed, TransformsKeepOrientation) {
    std::mt19937_64 random(11);
    std::size_t seen = 0;
    for (int round = 0; round < 300; ++round) {
        const csg::Tree tree = random_tree::make_tree(random_tree::make_model(random));
        const csg::Scene scene = csg::make_scene(tree);
        csg::solid::SolidCache cache;
        const csg::solid::Geometry geometry = csg::solid::place(tree, scene, cache);
        for (std::size_t i = 0; i < geometry.leaves.size(); ++i) {
            const csg::solid::PlacedLeaf& leaf = geometry.leaves[i];
            ASSERT_EQ(leaf.planes.size(), leaf.triangles.size());
            if (leaf.triangles.empty()) {
                continue;
            }
            ++seen;
            const double before = mesh_volume(leaf.solid->points, leaf.solid->triangles);
            const double scale = std::abs(glm::determinant(glm::dmat3(scene.leaves[i].to_world)));
            EXPECT_NEAR(mesh_volume(leaf.points, leaf.triangles), before * scale,
                        1e-9 * (1 + std::abs(before * scale)));
            EXPECT_EQ(closed(leaf.triangles), leaf.solid->closed);
            for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
                const csg::solid::Plane& plane = geometry.planes.planes()[leaf.planes[t].index];
                const glm::dvec3 a = leaf.points[leaf.triangles[t].x], b = leaf.points[leaf.triangles[t].y],
                                 c = leaf.points[leaf.triangles[t].z];
                for (const glm::dvec3& p : {a, b, c}) {
                    EXPECT_LE(std::abs(glm::dot(plane.normal, p) - plane.offset), geometry.planes.tolerance());
                }
                EXPECT_EQ(glm::dot(plane.normal, glm::cross(b - a, c - a)) < 0, leaf.planes[t].flipped);
            }
        }
    }
    EXPECT_GT(seen, 1000U);
}

TEST(Placed, MatricesThatAreNotAffineLeaveTheLeafOut) {
    for (int kind = 0; kind < 3; ++kind) {
        glm::dmat4 m(1.0);
        if (kind == 0) {
            m[0][0] = std::nan("");
        } else if (kind == 1) {
            m[0][3] = 0.5;
        } else {
            m[2] = glm::dvec4(0);
        }
        const random_tree::Model leaf{csg::Operation::Leaf, {}, csg::Cube{}, glm::dmat4(1.0), {}, {}};
        const csg::Tree tree = random_tree::make_tree({csg::Operation::Transform, {}, csg::Cube{}, m, {}, {leaf}});
        const csg::Scene scene = csg::make_scene(tree);
        csg::solid::SolidCache cache;
        const auto geometry = csg::solid::place(tree, scene, cache);
        ASSERT_EQ(geometry.leaves.size(), 1U);
        EXPECT_TRUE(geometry.leaves[0].triangles.empty() && geometry.leaves[0].box.empty());
        EXPECT_EQ(geometry.failures.empty(), kind == 2);
    }
}

TEST(SolidCache, AFailureIsToldEveryTimeThatTheMeshIsAskedFor) {
    // Two cubes as one mesh, with nothing at hand that could unite them.
    csg::TreeBuilder builder;
    static_cast<void>(builder.file("two.scad"));
    const csg::NodeId cubes[]{builder.leaf(csg::Cube{{1, 1, 1}, false}, {}),
                              builder.leaf(csg::Cube{{1, 1, 1}, true}, {})};
    const csg::Tree tree = builder.finish(builder.mesh({csg::Resize{{4, 4, 4}, {}}}, cubes, {}));
    const csg::Scene scene = csg::make_scene(tree);
    csg::solid::SolidCache cache;
    const auto first = csg::solid::place(tree, scene, cache).failures;
    EXPECT_FALSE(first.empty());
    EXPECT_EQ(csg::solid::place(tree, scene, cache).failures, first);
}

}  // namespace
