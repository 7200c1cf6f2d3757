// Booleans against closed forms: volume, area, pieces and handles.
#include <gtest/gtest.h>

#include <set>

#include "tests/csg/reference/meshes.h"

namespace {

struct Case {
    const char* name;
    const char* program;
    double volume;
    std::size_t components;
    long genus;
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

class ClosedForms : public testing::TestWithParam<Case> {};

TEST_P(ClosedForms, VolumePiecesAndHandles) {
    const auto model = meshes::model_of(GetParam().program);
    const ui::ModelMesh mesh = ui::make_mesh(*model);
    EXPECT_TRUE(mesh.facts.manifold);
    EXPECT_NEAR(mesh.facts.volume, GetParam().volume, 1e-9 * GetParam().volume);
    EXPECT_EQ(mesh.facts.components, GetParam().components);
    EXPECT_EQ(mesh.facts.genus, GetParam().genus);
    EXPECT_NE(mesh.method, "exact") << mesh.reason;
}

// Sides of a regular 6-gon prism of radius 1: area 3 √3 / 2.
constexpr double kHexagon = 2.598076211353316;

const Case kCases[] = {
    {"Cube", "cube([2, 3, 4]);", 24, 1, 0},
    {"Drilled", "difference() { cube(4, center = true); cylinder(h = 9, r = 1, $fn = 6, center = true); }",
     64 - 4 * kHexagon, 1, 1},
    {"DrilledFlush", "difference() { cube(4); translate([2, 2, 0]) cylinder(h = 4, r = 1, $fn = 6); }",
     64 - 4 * kHexagon, 1, 1},
    {"BlindFlush", "difference() { cube(4); translate([2, 2, 2]) cylinder(h = 2, r = 1, $fn = 6); }", 64 - 2 * kHexagon,
     1, 0},
    {"Cavity", "difference() { cube(4, center = true); cube(2, center = true); }", 64 - 8, 2, 0},
    {"ThreeWays",
     "difference() { cube(6, center = true); for (r = [[0,0,0],[90,0,0],[0,90,0]]) rotate(r) "
     "cube([2, 2, 9], center = true); }",
     216 - 3 * 24 + 2 * 8, 1, 5},
    {"TwoBlocksThatTouch", "cube(2); translate([2, 0, 0]) cube(2);", 16, 1, 0},
    {"TwoBlocksThatTouchInPart", "cube(2); translate([2, 1, 1]) cube(2);", 16, 1, 0},
    {"TouchAtAnEdge", "cube(2); translate([2, 2, 0]) cube(2);", 16, 2, 0},
    {"TouchAtACorner", "cube(2); translate([2, 2, 2]) cube(2);", 16, 2, 0},
    {"Same", "intersection() { cube(2); cube(2); }", 8, 1, 0},
    {"Apart", "cube(1); translate([5, 0, 0]) cube(1);", 2, 2, 0},
    {"TurnedFlush",
     "rotate([17, 29, 43]) difference() { cube(4); translate([1, 1, 2]) cube(2); translate([3, 0, 0]) cube(4); }",
     64 - 8 - 16, 1, 0},
    {"FarAway", "translate([1e4, -2e4, 5e3]) difference() { cube(4); translate([1, 1, -1]) cube([2, 2, 6]); }", 64 - 16,
     1, 1},
    {"MirroredAndScaled", "mirror([1, 0, 0]) scale([1, 2, 0.5]) cube(2);", 8, 1, 0},
    {"InsideOutPolyhedron", "polyhedron([[0,0,0],[2,0,0],[0,2,0],[0,0,3]], [[0,2,1],[0,1,3],[1,2,3],[2,0,3]]);", 2, 1,
     0},
    // Two bars in a cross share an edge with a third: the four meet along lines.
    {"CheckerBoard", "for (x = [0:3], y = [0:3]) if ((x + y) % 2 == 0) translate([x, y, 0]) cube(1);", 8, 8, 0},
    {"BoardOfCubesAtCorners",
     "for (p = [0:26]) let (x = p % 3, y = floor(p / 3) % 3, z = floor(p / 9)) "
     "if ((x + y + z) % 2 == 0) translate([x, y, z]) cube(1);",
     14, 14, 0},
    {"FourFacesAtAnEdge",
     "linear_extrude(2) difference() { square(6); translate([1, 1]) square(2); translate([3, 3]) square(2); }", 56, 1,
     1},
    // The middle is wound around twice.
    {"PentagramPrism",
     "p = [for (z = [0, 2]) each [[0, 0, z], for (i = [0:4]) [10 * cos(144 * i), 10 * sin(144 * i), z]]];\n"
     "polyhedron(p, [for (i = [0:4]) let (a = 1 + i, b = 1 + (i + 1) % 5) "
     "each [[0, a, b], [6, 6 + b, 6 + a], [a, 6 + a, 6 + b], [a, 6 + b, b]]]);",
     224.5139882897927, 1, 0},
    {"TranslucentPartsCount", "cube(2); color([1, 0, 0, 0.5]) translate([1, 0, 0]) cube(2);", 12, 1, 0},
    {"BackgroundDoesNot", "cube(2); %cube(5); ", 8, 1, 0},
};

INSTANTIATE_TEST_SUITE_P(Booleans, ClosedForms, testing::ValuesIn(kCases),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(ClosedForms, ExactArithmeticGivesTheSame) {
    const auto model = meshes::model_of(GetParam().program);
    csg::reference::BooleanRequest request;
    request.method = csg::reference::Method::Exact;
    const auto exact = csg::reference::make_mesh(model->scene, model->geometry, request);
    EXPECT_TRUE(exact.facts.manifold);
    EXPECT_NEAR(exact.facts.volume, GetParam().volume, 1e-9 * GetParam().volume);
}

/// Shells of one polyhedron: boxes given by two corners, turned inside out where the first is the larger one.
std::string shells(const std::string& boxes) {
    return "function box(b) = [for (z = [b[0].z, b[1].z], y = [b[0].y, b[1].y], x = [b[0].x, b[1].x]) [x, y, z]];\n"
           "f = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [1, 5, 7, 3], [3, 7, 6, 2], [2, 6, 4, 0]];\n"
           "module shells(boxes) polyhedron([for (b = boxes) each box(b)],\n"
           "    [for (i = [0:len(boxes) - 1]) each [for (g = f) [for (k = g) k + 8 * i]]]);\n"
           "shells(" +
           boxes + ");";
}

struct Shells {
    const char* name;
    const char* boxes;
    double volume;
};

/// Inside is where the winding number is not 0.
class ShellsOfOneLeaf : public testing::TestWithParam<Shells> {};

TEST_P(ShellsOfOneLeaf, AreInsideWhereTheyWind) {
    const auto model = meshes::model_of(shells(GetParam().boxes));
    for (const auto method : {csg::reference::Method::Planes, csg::reference::Method::Exact}) {
        csg::reference::BooleanRequest request;
        request.method = method;
        const auto result = csg::reference::make_mesh(model->scene, model->geometry, request);
        EXPECT_TRUE(result.facts.manifold) << csg::reference::name(method);
        EXPECT_NEAR(result.facts.volume, GetParam().volume, 1e-9 * GetParam().volume) << csg::reference::name(method);
    }
}

const Shells kShells[] = {
    {"Overlapping", "[[[0,0,0],[2,2,2]], [[1,1,1],[3,3,3]]]", 15},
    {"OneInTheOther", "[[[0,0,0],[3,3,3]], [[1,1,1],[2,2,2]]]", 27},
    {"ReversedInTheOtherIsACavity", "[[[0,0,0],[3,3,3]], [[2,2,2],[1,1,1]]]", 26},
    {"ReversedOverlapIsTakenAway", "[[[0,0,0],[2,2,2]], [[3,3,3],[1,1,1]]]", 14},
    {"BothReversed", "[[[2,2,2],[0,0,0]], [[3,3,3],[1,1,1]]]", 15},
    {"Doubled", "[[[0,0,0],[2,2,2]], [[0,0,0],[2,2,2]]]", 8},
    {"ThreeTimes", "[[[0,0,0],[2,2,2]], [[0,0,0],[2,2,2]], [[0,0,0],[2,2,2]]]", 8},
    {"DoubledAndReversed", "[[[0,0,0],[2,2,2]], [[0,0,0],[2,2,2]], [[2,2,2],[0,0,0]]]", 8},
    {"SharingAFace", "[[[0,0,0],[2,2,2]], [[2,0,0],[4,2,2]]]", 16},
    {"SharingAPartOfAFace", "[[[0,0,0],[2,2,2]], [[2,1,1],[4,3,3]]]", 16},
    {"SharingAnEdge", "[[[0,0,0],[2,2,2]], [[2,2,0],[4,4,2]]]", 16},
    {"SharingACorner", "[[[0,0,0],[2,2,2]], [[2,2,2],[4,4,4]]]", 16},
    {"FaceInFace", "[[[0,0,0],[2,2,2]], [[0,0,0],[1,1,3]]]", 9},
};

INSTANTIATE_TEST_SUITE_P(Booleans, ShellsOfOneLeaf, testing::ValuesIn(kShells),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Booleans, SourcesAreTheLeavesThatShow) {
    const auto model = meshes::model_of("difference() { cube(4); translate([1, 1, 2]) cube([2, 2, 2]); }");
    const ui::ModelMesh mesh = ui::make_mesh(*model);
    for (std::size_t i = 0; i < mesh.mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.mesh.triangles[i];
        const glm::dvec3 c = (mesh.mesh.points[t.x] + mesh.mesh.points[t.y] + mesh.mesh.points[t.z]) / 3.0;
        const bool outer = c.x == 0 || c.x == 4 || c.y == 0 || c.y == 4 || c.z == 0 || c.z == 4;
        EXPECT_EQ(mesh.mesh.sources[i], outer ? 0u : 1u);
    }
}

TEST(Booleans, TrianglesKnowLeafPartLineAndColor) {
    const auto model = meshes::model_of(
        "color(\"red\") difference() {\n  cube(4);\n  translate([1, 1, 2]) cube([2, 2, 2]);\n}\n"
        "color([0, 0, 1, 0.5]) translate([9, 0, 0]) cube(1);");
    const ui::ModelMesh mesh = ui::make_mesh(*model);
    std::set<std::uint32_t> lines;
    for (std::size_t i = 0; i < mesh.mesh.triangles.size(); ++i) {
        const csg::LeafInstance& leaf = model->scene.leaves[mesh.mesh.sources[i]];
        const double x = mesh.mesh.points[mesh.mesh.triangles[i].x].x;
        lines.insert(leaf.where.line);
        EXPECT_EQ(leaf.part, x < 8 ? 0u : 1u);
        EXPECT_EQ(leaf.where.line == 5, x > 8);
        EXPECT_EQ(leaf.color.r, x < 8 ? 1.0f : 0.0f);
    }
    EXPECT_EQ(lines, (std::set<std::uint32_t>{2, 3, 5}));
}

TEST(Booleans, NothingIsAnError) {
    EXPECT_THROW((void)ui::make_mesh(*meshes::model_of("")), ui::ModelError);
    EXPECT_THROW((void)ui::make_mesh(*meshes::model_of("difference() { cube(1); cube(1); }")), ui::ModelError);
    EXPECT_THROW((void)ui::make_mesh(*meshes::model_of("%cube(1);")), ui::ModelError);
}

constexpr const char* kOpen =
    "module open() polyhedron([[0,0,0],[2,0,0],[0,2,0],[0,0,3]], [[0,2,1],[0,1,3],[1,2,3]]);\n";

TEST(Booleans, AnOpenLeafStaysAsItIsWhereNothingMeetsIt) {
    const ui::ModelMesh alone = ui::make_mesh(*meshes::model_of(std::string(kOpen) + "open();"));
    EXPECT_EQ(alone.mesh.triangles.size(), 3u);
    EXPECT_FALSE(alone.facts.manifold);
    const ui::ModelMesh apart =
        ui::make_mesh(*meshes::model_of(std::string(kOpen) + "open(); translate([5, 0, 0]) cube(1);"));
    EXPECT_EQ(apart.mesh.sources.back(), 0u);
    EXPECT_EQ(apart.mesh.triangles.size(), 3u + 12u);
}

TEST(Booleans, AnOpenLeafCannotBeCombined) {
    for (const char* program : {"union() {\nopen(); cube(1); }", "difference() {\nopen(); cube(1); }",
                                "difference() { cube(9);\nopen(); }", "intersection() {\nopen(); cube(9); }"}) {
        try {
            (void)ui::make_mesh(*meshes::model_of(std::string(kOpen) + program));
            ADD_FAILURE() << program;
        } catch (const ui::ModelError& error) {
            EXPECT_EQ(std::string(error.what()).find("test.scad:1: its surface is open"), 0u) << error.what();
        }
    }
}

/// Points that the planes would take for one.
TEST(Booleans, SmallSolidsFarAwayKeepTheirDetails) {
    const ui::ModelMesh far = ui::make_mesh(*meshes::model_of("translate([1e15, 1e15, 1e15]) cube(1); cube(1);"));
    EXPECT_EQ(far.facts.components, 2u);
    const ui::ModelMesh drilled =
        ui::make_mesh(*meshes::model_of("translate([1e7, 1e5, 1e7]) difference() { cube(4, center = true); cylinder(h "
                                        "= 9, r = 1, $fn = 6, center = true); }"));
    EXPECT_NEAR(drilled.facts.volume, 64 - 4 * kHexagon, 1e-6);
}

TEST(Booleans, CoordinatesThatAreTooLargeAreTold) {
    try {
        (void)ui::make_mesh(*meshes::model_of("cube(1);\ncube(1e300);"));
        ADD_FAILURE();
    } catch (const ui::ModelError& error) {
        EXPECT_EQ(std::string(error.what()).find("test.scad:2: this object is left out: its coordinates reach 1e+300"),
                  0u)
            << error.what();
    }
}

/// Every edge has two faces, but some are turned the wrong way: even-odd.
TEST(Booleans, ALeafOfUnevenlyOrientedFacesIsEvenOdd) {
    const auto model =
        meshes::model_of("polyhedron([[0,0,0],[2,0,0],[0,2,0],[0,0,3]], [[0,1,2],[0,1,3],[1,2,3],[2,0,3]]);");
    for (const auto method : {csg::reference::Method::Planes, csg::reference::Method::Exact}) {
        csg::reference::BooleanRequest request;
        request.method = method;
        const auto result = csg::reference::make_mesh(model->scene, model->geometry, request);
        EXPECT_TRUE(result.facts.manifold);
        EXPECT_NEAR(result.facts.volume, 2, 1e-12);
    }
}

TEST(Booleans, ThreadsDoNotMatter) {
    const auto model = meshes::model_of(
        "difference() { sphere(5, $fn = 40); for (i = [0:9]) rotate(36 * i) "
        "translate([5, 0, 0]) sphere(1, $fn = 20); }");
    csg::reference::BooleanRequest one, four;
    one.threads = 1;
    four.threads = 4;
    const auto a = csg::reference::make_mesh(model->scene, model->geometry, one);
    const auto b = csg::reference::make_mesh(model->scene, model->geometry, four);
    EXPECT_EQ(a.mesh.points, b.mesh.points);
    EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
    EXPECT_EQ(a.mesh.sources, b.mesh.sources);
}

}  // namespace
