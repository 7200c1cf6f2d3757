// Radii, distances, angles, edges and corners against closed forms: shapes placed by rotations, scales and mirrors,
// what is no longer round, and what has to be fitted.
#include "ui/pipeline/inspection/measured.h"

#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

#include "tests/csg/scad/evaluate_text.h"
#include "ui/pipeline/picture/renderer.h"

namespace ui {
namespace {

using csg::solid::FormKind;

std::shared_ptr<const Model> model_of(const std::string& text) {
    const test::Run run = test::run(text);
    EXPECT_TRUE(run.evaluation.ok) << run.console;
    return ModelBuilder().build(run.evaluation.tree);
}

/// The round surface of the model's first leaf.
Measured round_of(const std::string& text) {
    const auto model = model_of(text);
    const auto found = measured_round(*model, 0);
    EXPECT_TRUE(found.has_value()) << text;
    return found.value_or(Measured());
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
    EXPECT_NEAR(glm::distance(a, b), 0, tolerance)
        << fmt::format("{} {} {} is not {} {} {}", a.x, a.y, a.z, b.x, b.y, b.z);
}

/// Straight down onto a point, from above all.
std::vector<PickedSurface> look_down(const Model& model, double x, double y) {
    base::Camera camera;
    camera.projection = base::Projection::Orthographic;
    camera.rotation = glm::dvec3(0);
    camera.target = {x, y, 0};
    camera.distance = 500;
    Renderer renderer({}, Painter::Cpu);
    return renderer.pick(model, pixel_camera(camera, {100, 100}, {50, 50}), 0);
}

// What keeps circles round, and by how much it scales them.
struct Move {
    const char* text;
    double scale;
};
constexpr Move kMoves[]{{"", 1},
                        {"rotate([12, 34, 56]) translate([7, -3, 11])", 1},
                        {"translate([1, 2, 3]) mirror([1, 2, 0.5]) rotate([80, 0, 31])", 1},
                        {"rotate([0, 70, 15]) scale(2.5) mirror([0, 0, 1])", 2.5},
                        {"scale([-3, 3, 3]) rotate([10, 20, 30])", 3},
                        {"multmatrix([[0, -2, 0, 5], [2, 0, 0, 6], [0, 0, 2, 7]])", 2}};

TEST(Measured, RadiiAreThoseOfTheTreeThroughItsPlacement) {
    for (const Move& move : kMoves) {
        const Measured cylinder = round_of(fmt::format("{} cylinder(r = 3, h = 7, $fn = 24);", move.text));
        EXPECT_EQ(cylinder.form.kind, FormKind::Cylinder) << move.text;
        EXPECT_NEAR(cylinder.radius().value_or(0), 3 * move.scale, 1e-12) << move.text;
        EXPECT_TRUE(cylinder.form.exact);
        EXPECT_EQ(cylinder.form.segments, 24);
        const Measured sphere = round_of(fmt::format("{} sphere(d = 5);", move.text));
        EXPECT_EQ(sphere.form.kind, FormKind::Sphere) << move.text;
        EXPECT_NEAR(sphere.radius().value_or(0), 2.5 * move.scale, 1e-12) << move.text;
        const Measured cone = round_of(fmt::format("{} cylinder(r1 = 1, r2 = 4, h = 3);", move.text));
        EXPECT_EQ(cone.form.kind, FormKind::Cone) << move.text;
        EXPECT_FALSE(cone.radius()) << "it has another everywhere";
        EXPECT_NEAR(glm::degrees(cone.form.half_angle), 45, 1e-9) << move.text;
        const Measured ring = round_of(fmt::format("{} rotate_extrude() translate([9, 1]) circle(2);", move.text));
        EXPECT_EQ(ring.form.kind, FormKind::Torus) << move.text;
        EXPECT_NEAR(ring.form.radius, 2 * move.scale, 1e-12);
        EXPECT_NEAR(ring.form.ring_radius, 9 * move.scale, 1e-12);
    }
}

TEST(Measured, AxesAndCentersMoveAlong) {
    const Measured cylinder =
        round_of("translate([1, 2, 3]) rotate([90, 0, 0]) scale([2, 2, 5]) cylinder(r = 3, h = 4);");
    EXPECT_NEAR(cylinder.radius().value_or(0), 6, 1e-12) << "a longer one is still round";
    expect_near(cylinder.form.point, {1, 2 - 10, 3});
    EXPECT_NEAR(std::abs(cylinder.form.direction.y), 1, 1e-12);
    const Measured cone = round_of("translate([1, 2, 3]) cylinder(r1 = 4, r2 = 2, h = 4);");
    expect_near(cone.form.point, {1, 2, 11});
    expect_near(cone.form.direction, {0, 0, -1});
    const Measured tapered = round_of("linear_extrude(4, scale = 0.5) circle(4);");
    EXPECT_EQ(tapered.form.kind, FormKind::Cone);
    expect_near(tapered.form.point, {0, 0, 8});
}

TEST(Measured, WhatIsScaledUnevenlyHasNoRadius) {
    for (const char* text :
         {"scale([1, 2, 1]) cylinder(r = 3, h = 4);", "scale([1, 1, 2]) sphere(3);",
          "scale([2, 1, 1]) rotate([0, 30, 0]) cylinder(r1 = 1, r2 = 2, h = 4);",
          "multmatrix([[1, 0, 0.5, 0], [0, 1, 0, 0], [0, 0, 1, 0]]) cylinder(r = 3, h = 4);",
          "linear_extrude(3, scale = [1, 2]) circle(3);", "linear_extrude(3, v = [1, 0, 1]) circle(3);",
          "linear_extrude(3, scale = 2) translate([20, 0]) circle(3);",
          "scale([1, 1, 2]) rotate_extrude() translate([9, 0]) circle(2);"}) {
        const Measured found = round_of(text);
        EXPECT_EQ(found.form.kind, FormKind::Plane) << text;
        EXPECT_FALSE(found.form.remark.empty()) << text;
        EXPECT_FALSE(found.radius()) << text;
    }
    EXPECT_NEAR(round_of("scale([1, 2, 1]) scale([1, 0.5, 1]) cylinder(r = 3, h = 4);").radius().value_or(0), 3, 1e-12)
        << "what is made round again is round";
}

TEST(Measured, CirclesOfThePlaneAreFoundInWhatTheyAreSweptTo) {
    const auto model = model_of(
        "linear_extrude(5) difference() { hull() { circle(8); translate([30, 0]) circle(8); } circle(3); "
        "translate([30, 0]) square(4, center = true); }");
    const auto slot = model_of("linear_extrude(5) hull() { circle(8); translate([30, 0]) circle(8); }");
    EXPECT_NEAR(measured_face(*slot, 0, {1, 0.3, 0}).radius().value_or(0), 8, 1e-12);
    EXPECT_EQ(measured_face(*slot, 0, {0, 1, 0}).form.kind, FormKind::Plane) << "its straight side";
    const auto surfaces = look_down(*model, 10, 0);
    ASSERT_FALSE(surfaces.empty());
    const auto rim = EdgeFinder(*model).edge(surfaces.front());
    ASSERT_TRUE(rim);
    EXPECT_EQ(rim->kind, Measured::Kind::Circle);
    EXPECT_NEAR(rim->radius().value_or(0), 3, 1e-12);
    expect_near(rim->form.point, {0, 0, 5});
}

TEST(Measured, WhatTheTreeDoesNotKnowIsFitted) {
    // An offset's arcs, and a ball and a cone by their corners alone.
    const Measured rounded =
        measured_face(*model_of("linear_extrude(4) offset(r = 2, $fn = 64) square(20);"), 0, glm::dvec3(1, 1.05, 0));
    EXPECT_EQ(rounded.form.kind, FormKind::Cylinder);
    EXPECT_FALSE(rounded.form.exact);
    EXPECT_NEAR(rounded.form.radius, 2, 1e-6);
    const char* const kBall =
        "n = 24; module ball(r) polyhedron([for (i = [0:n / 2 - 1], j = [0:n - 1]) let (a = 180 * (i + 0.5) / (n / 2), "
        "b = 360 * j / n) r * [sin(a) * cos(b), sin(a) * sin(b), cos(a)]], concat([[for (j = [0:n - 1]) n - 1 - j]], "
        "[for (i = [0:n / 2 - 2], j = [0:n - 1]) [i * n + j, i * n + (j + 1) % n, (i + 1) * n + (j + 1) % n, "
        "(i + 1) * n + j]], [[for (j = [0:n - 1]) (n / 2 - 1) * n + j]]));";
    const auto ball = model_of(fmt::format("{} translate([3, 4, 5]) ball(6);", kBall));
    const Measured sphere = measured_face(*ball, 0, glm::dvec3(1, 0.5, 0.4));
    EXPECT_EQ(sphere.form.kind, FormKind::Sphere) << sphere.form.remark;
    EXPECT_FALSE(sphere.form.exact);
    EXPECT_NEAR(sphere.form.radius, 6, 1e-6);
    expect_near(sphere.form.point, {3, 4, 5}, 1e-6);
    const char* const kCone =
        "n = 24; polyhedron(concat([for (i = [0:n - 1]) [4 * cos(360 * i / n), 4 * sin(360 * i / n), 0]], "
        "[for (i = [0:n - 1]) [2 * cos(360 * i / n), 2 * sin(360 * i / n), 2]]), concat([[for (i = [0:n - 1]) i]], "
        "[for (i = [0:n - 1]) [i, n + i, n + (i + 1) % n, (i + 1) % n]], [[for (i = [0:n - 1]) 2 * n - 1 - i]]));";
    const Measured cone = measured_face(*model_of(kCone), 0, glm::dvec3(1, 0, 1));
    EXPECT_EQ(cone.form.kind, FormKind::Cone) << cone.form.remark;
    EXPECT_NEAR(glm::degrees(cone.form.half_angle), 45, 1e-6);
    expect_near(cone.form.point, {0, 0, 4}, 1e-6);
}

TEST(Measured, EdgesEndWhereTheModelDoes) {
    // The step of the notch cuts the block's upper edge; both are turned out of the axes.
    for (const char* move : {"", "rotate([0, 0, 25])", "mirror([0, 1, 0])"}) {
        const auto model = model_of(
            fmt::format("{} difference() {{ cube([40, 20, 10]); translate([15, -1, 6]) cube([8, 6, 9]); }}", move));
        const glm::dmat4 to_world = model->scene.leaves[0].to_world;
        const auto place = [&](double x, double y, double z) { return glm::dvec3(to_world * glm::dvec4(x, y, z, 1)); };
        const EdgeFinder finder(*model);
        const auto top = look_down(*model, place(5, 2, 0).x, place(5, 2, 0).y);
        ASSERT_FALSE(top.empty());
        const auto edge = finder.edge(top.front());
        ASSERT_TRUE(edge);
        EXPECT_EQ(edge->kind, Measured::Kind::Edge);
        EXPECT_NEAR(glm::distance(edge->from, edge->to), 15, 1e-9) << "up to the notch";
        const auto corner = finder.corner(look_down(*model, place(14, 1, 0).x, place(14, 1, 0).y).front());
        ASSERT_TRUE(corner);
        expect_near(corner->at, place(15, 0, 10));
        const auto floor = finder.edge(look_down(*model, place(19, 4.5, 0).x, place(19, 4.5, 0).y).front());
        ASSERT_TRUE(floor);
        EXPECT_NEAR(glm::distance(floor->from, floor->to), 8, 1e-9) << "a hollow edge of the notch";
        EXPECT_NEAR(0.5 * (floor->from + floor->to).z, 6, 1e-9);
    }
}

TEST(Measured, PlanesCutSpheresInCircles) {
    const auto model = model_of("translate([1, 2, 0]) intersection() { sphere(5, $fn = 60); cube(8, center = true); }");
    const auto rim = EdgeFinder(*model).edge(look_down(*model, 1.5, 2.5).front());
    ASSERT_TRUE(rim);
    EXPECT_EQ(rim->kind, Measured::Kind::Circle);
    EXPECT_NEAR(rim->radius().value_or(0), 3, 1e-12);
    expect_near(rim->form.point, {1, 2, 4});
}

TEST(Measured, JointsOfFacetsAreNoEdges) {
    const auto model = model_of("rotate([0, 90, 0]) cylinder(r = 5, h = 30, center = true);");
    const auto surfaces = look_down(*model, 3, 0.2);
    ASSERT_FALSE(surfaces.empty());
    EXPECT_NEAR(measured_face(*model, surfaces.front()).radius().value_or(0), 5, 1e-12);
    const auto rim = EdgeFinder(*model).edge(surfaces.front());
    ASSERT_TRUE(rim);
    EXPECT_EQ(rim->kind, Measured::Kind::Circle);
    expect_near(rim->form.point, {15, 0, 0});
    EXPECT_FALSE(EdgeFinder(*model_of("sphere(5);")).edge(look_down(*model_of("sphere(5);"), 1, 0.5).front()));
}

TEST(Relation, DistancesAndAnglesAreThoseOfTheFormula) {
    const auto model = model_of(
        "cube([10, 20, 30]);\n"
        "rotate([90, 0, 0]) translate([40, 5, 0]) cylinder(r = 2, h = 9);\n"   // Axis along y, through x 40, z 5.
        "translate([40, 0, 25]) rotate([0, 90, 0]) cylinder(r = 3, h = 9);\n"  // Along x, at z 25.
        "translate([0, 60, 0]) sphere(4);\n"
        "rotate([0, 0, 30]) translate([100, 0, 0]) cube(5);\n"
        "translate([52, 50, 5]) rotate([90, 0, 0]) cylinder(r = 1, h = 9);\n");  // Beside the first.
    const auto face = [&](csg::LeafId leaf, glm::dvec3 towards) { return measured_face(*model, leaf, towards); };
    const auto round = [&](csg::LeafId leaf) { return measured_round(*model, leaf).value(); };

    const Relation planes = relation_of(face(0, {1, 0, 0}), face(0, {-1, 0, 0}));
    EXPECT_NEAR(planes.distance.value_or(0), 10, 1e-12);
    EXPECT_TRUE(planes.parallel);
    const Relation upright = relation_of(face(0, {1, 0, 0}), face(0, {0, 0, 1}));
    EXPECT_FALSE(upright.distance) << "they meet";
    EXPECT_NEAR(upright.degrees.value_or(0), 90, 1e-9);
    EXPECT_NEAR(relation_of(face(0, {1, 0, 0}), face(4, {1, 0.6, 0})).degrees.value_or(0), 30, 1e-9);

    const Relation skew = relation_of(round(1), round(2));
    EXPECT_NEAR(skew.distance.value_or(0), 20, 1e-9);
    EXPECT_NEAR(skew.degrees.value_or(0), 90, 1e-9);
    EXPECT_FALSE(skew.most);
    const Relation beside = relation_of(round(1), round(5));
    EXPECT_NEAR(beside.distance.value_or(0), 12, 1e-9);
    EXPECT_NEAR(beside.least.value_or(0), 9, 1e-9);
    EXPECT_NEAR(beside.most.value_or(0), 15, 1e-9);

    const Relation to_plane = relation_of(round(1), face(0, {1, 0, 0}));
    EXPECT_NEAR(to_plane.distance.value_or(0), 30, 1e-9);
    EXPECT_NEAR(to_plane.degrees.value_or(9), 0, 1e-9);
    EXPECT_FALSE(relation_of(round(2), face(0, {1, 0, 0})).distance) << "the axis goes through it";

    const Relation ball = relation_of(round(3), face(0, {0, 1, 0}));
    EXPECT_NEAR(ball.distance.value_or(0), 40, 1e-9);
    EXPECT_NEAR(ball.least.value_or(0), 36, 1e-9);
    EXPECT_FALSE(ball.degrees);

    const Relation point = relation_of(measured_point({13, 4, 5}), face(0, {1, 0, 0}));
    EXPECT_NEAR(point.distance.value_or(0), 3, 1e-12);
    expect_near(point.to, {10, 4, 5});
    EXPECT_NEAR(relation_of(measured_point({1, 2, 3}), measured_point({4, 6, 3})).distance.value_or(0), 5, 1e-12);
}

TEST(Relation, EdgesHaveEnds) {
    const auto edge = [](glm::dvec3 from, glm::dvec3 to) {
        Measured e;
        e.kind = Measured::Kind::Edge;
        e.from = from;
        e.to = to;
        return e;
    };
    const Measured x = edge({0, 0, 0}, {10, 0, 0});
    EXPECT_NEAR(relation_of(x, measured_point({13, 4, 0})).distance.value_or(0), 5, 1e-12);
    EXPECT_NEAR(relation_of(x, edge({13, 4, -5}, {13, 4, 5})).distance.value_or(0), 5, 1e-12);
    EXPECT_NEAR(relation_of(x, edge({4, 3, 0}, {30, 3, 0})).distance.value_or(0), 3, 1e-12);
    EXPECT_NEAR(relation_of(x, edge({14, 3, 0}, {30, 3, 0})).distance.value_or(0), 5, 1e-12);
    EXPECT_NEAR(relation_of(edge({14, 3, 0}, {30, 3, 0}), x).distance.value_or(0), 5, 1e-12);
    EXPECT_NEAR(relation_of(x, edge({-9, 3, 0}, {-4, 3, 0})).distance.value_or(0), 5, 1e-12);
    EXPECT_NEAR(relation_of(x, edge({2, 1, 1}, {2, 9, 1})).distance.value_or(0), std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(relation_of(x, edge({2, -1, 1}, {2, 9, 1})).distance.value_or(0), 1, 1e-12);
}

}  // namespace
}  // namespace ui
