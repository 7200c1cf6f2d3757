// The exact arrangement against the planes' one, sampled winding numbers and files that once had no mesh.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "csg/reference/mesh_boolean.h"
#include "tests/csg/reference/membership.h"
#include "tests/csg/reference/meshes.h"
#include "tests/csg/reference/random_numbers.h"

namespace {

using csg::reference::BooleanRequest;
using csg::reference::BooleanResult;
using csg::reference::Mesh;
using csg::reference::Method;
using meshes::Random;

BooleanResult by(Method method, const csg::Scene& scene, const csg::solid::Geometry& geometry) {
    BooleanRequest request;
    request.method = method;
    return csg::reference::make_mesh(scene, geometry, request);
}

/// A grid of points that closes in both directions; each square is cut along one of its diagonals.
Mesh closed_grid(int n, int m, Random& random, const std::function<glm::dvec3(int, int)>& at) {
    Mesh mesh;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) {
            mesh.points.push_back(at(i, j));
        }
    }
    const auto id = [&](int i, int j) { return static_cast<std::uint32_t>(i % n * m + j % m); };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) {
            const std::uint32_t a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
            if (random.chance(0.5)) {
                mesh.triangles.emplace_back(a, b, c);
                mesh.triangles.emplace_back(a, c, d);
            } else {
                mesh.triangles.emplace_back(a, b, d);
                mesh.triangles.emplace_back(b, c, d);
            }
        }
    }
    return mesh;
}

Mesh noisy_torus(Random& random) {
    const int n = random.whole(5, 20), m = random.whole(4, 12), turns = random.whole(1, 2);
    const double noise = random.number(0, 2);
    return closed_grid(n, m, random, [&](int i, int j) {
        const double a = 2 * std::numbers::pi * i / n * turns, b = 2 * std::numbers::pi * j / m;
        const double r = 10 + 4 * std::cos(b);
        return glm::dvec3(r * std::cos(a), r * std::sin(a), 4 * std::sin(b)) +
               glm::dvec3(random.number(-noise, noise), random.number(-noise, noise), random.number(-noise, noise));
    });
}

/// Swept walls: rings outside up, inside down. Coordinates may be on a grid, so that much coincides.
Mesh noisy_wall(Random& random) {
    const int n = random.whole(6, 20), rings = random.whole(2, 4);
    const double noise = random.number(0.2, 2), grid = random.chance(0.5) ? random.whole(1, 2) * 0.5 : 0;
    return closed_grid(2 * rings, n, random, [&](int i, int j) {
        const bool outside = i < rings;
        const double a = -2 * std::numbers::pi * j / n, r = outside ? 10 : 8.5;
        const double z = 3 * (outside ? i : 2 * rings - 1 - i);
        glm::dvec3 p(r * std::cos(a) + random.number(-noise, noise), r * std::sin(a) + random.number(-noise, noise),
                     z + random.number(-0.3, 0.3) * noise);
        return grid > 0 ? glm::round(p / grid) * grid : p;
    });
}

/// Tetrahedra with corners on a small grid, either way around, many flat ones among them.
Mesh tetrahedra(Random& random) {
    Mesh mesh;
    const int count = random.whole(1, 10);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(4 * count); i += 4) {
        for (int k = 0; k < 4; ++k) {
            mesh.points.emplace_back(random.whole(0, 4), random.whole(0, 4), random.whole(0, 4));
        }
        for (const glm::uvec3 t :
             {glm::uvec3(0, 1, 2), glm::uvec3(0, 3, 1), glm::uvec3(1, 3, 2), glm::uvec3(0, 2, 3)}) {
            mesh.triangles.push_back(t + i);
        }
    }
    return mesh;
}

/// Boxes on a grid, some inside out: equal, flush, touching along faces, edges and corners, in each other.
Mesh boxes(Random& random) {
    Mesh mesh;
    const int count = random.whole(2, 8);
    for (int i = 0; i < count; ++i) {
        glm::dvec3 lo(random.whole(0, 5), random.whole(0, 5), random.whole(0, 5));
        glm::dvec3 hi = lo + glm::dvec3(random.whole(1, 3), random.whole(1, 3), random.whole(1, 3));
        if (random.chance(0.25)) {
            std::swap(lo, hi);
        }
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        for (unsigned k = 0; k < 8; ++k) {
            mesh.points.emplace_back((k & 1) ? hi.x : lo.x, (k & 2) ? hi.y : lo.y, (k & 4) ? hi.z : lo.z);
        }
        for (const glm::uvec4 f : {glm::uvec4(0, 2, 3, 1), glm::uvec4(4, 5, 7, 6), glm::uvec4(0, 1, 5, 4),
                                   glm::uvec4(2, 6, 7, 3), glm::uvec4(0, 4, 6, 2), glm::uvec4(1, 3, 7, 5)}) {
            mesh.triangles.push_back(glm::uvec3(f.x, f.y, f.z) + first);
            mesh.triangles.push_back(glm::uvec3(f.x, f.z, f.w) + first);
        }
    }
    return mesh;
}

void turn(Mesh& mesh, Random& random) {
    const double a = random.number(0, 3), b = random.number(0, 3);
    const glm::dmat3 x(1, 0, 0, 0, std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a));
    const glm::dmat3 z(std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b), 0, 0, 0, 1);
    for (glm::dvec3& p : mesh.points) {
        p = x * (z * p);
    }
}

struct Kind {
    const char* name;
    Mesh (*make)(Random&);
};

class RandomLeaves : public testing::TestWithParam<Kind> {};

/// Alone, without a corner, or with another one: both methods give the same closed solid, and the points in it are
/// those that the leaves wind around.
TEST_P(RandomLeaves, HaveAMeshByWindingNumbers) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        std::vector<Mesh> leaves{GetParam().make(random)};
        if (seed % 3 != 0) {
            leaves.push_back(GetParam().make(random));
        }
        if (seed % 4 == 3) {
            for (Mesh& leaf : leaves) {
                Random same(seed);
                turn(leaf, same);
            }
        }
        const auto operation = seed % 3 == 1 ? csg::ExpressionKind::Difference : csg::ExpressionKind::Union;
        const auto [scene, geometry] = csg::reference::make_mesh_scene(operation, leaves);
        BooleanResult result, exact;
        ASSERT_NO_THROW(result = csg::reference::make_mesh(scene, geometry));
        ASSERT_NO_THROW(exact = by(Method::Exact, scene, geometry));
        EXPECT_TRUE(result.facts.manifold);
        EXPECT_TRUE(exact.facts.manifold);
        EXPECT_NEAR(result.facts.volume, exact.facts.volume, 1e-8 * exact.facts.volume);
        EXPECT_EQ(meshes::count_wrong_points(scene, geometry, result.mesh, geometry.box, 60), 0u);
        EXPECT_EQ(meshes::count_wrong_points(scene, geometry, exact.mesh, geometry.box, 60), 0u);
    }
}

const Kind kKinds[] = {{"Tori", noisy_torus}, {"Walls", noisy_wall}, {"Tetrahedra", tetrahedra}, {"Boxes", boxes}};

INSTANTIATE_TEST_SUITE_P(Kinds, RandomLeaves, testing::ValuesIn(kKinds),
                         [](const auto& info) { return std::string(info.param.name); });

std::string small_part(Random& random) {
    const std::string placed = fmt::format("translate({}) rotate({}) ", random.vector(-3, 3),
                                           random.chance(0.5) ? "0" : random.vector(0, 180));
    switch (random.whole(0, 3)) {
        case 0:
            return placed + fmt::format("cube({:.3g}, center = true);", random.number(0.5, 4));
        case 1:
            return placed + fmt::format("sphere({:.3g}, $fn = {});", random.number(0.5, 3), random.whole(5, 30));
        case 2:
            return placed + fmt::format("cylinder(h = {:.3g}, r = {:.3g}, $fn = {}, center = true);",
                                        random.number(0.5, 9), random.number(0.3, 2), random.whole(3, 24));
        default:
            return placed + "linear_extrude(4) difference() { square(3, center = true); circle(1, $fn = 7); }";
    }
}

std::string far_part(Random& random) {
    constexpr int lengths[] = {999, 1000, 3333, 5000, 9999};
    const int n = lengths[random.whole(0, 4)];
    const double d = random.chance(0.5) ? 0.1 : random.number(0.01, 5), e = random.chance(0.5) ? 3 : d;
    const std::string turned = fmt::format("rotate({}) ", random.vector(0, 180));
    switch (random.whole(0, 4)) {
        case 0:
            return turned + fmt::format("cube([{}, {:.3g}, {:.3g}]);", n, d, e);
        case 1:
            return turned + fmt::format("cube([{}, {}, {:.3g}], center = true);", n, n, e);
        case 2:
            return turned + fmt::format("cylinder(h = {}, r = {:.3g}, $fn = {});", n, d, random.whole(3, 40));
        case 3:
            return turned + fmt::format("translate([0, 0, {}]) cube({}, center = true);", n / 2, n);
        default:
            return turned + fmt::format("cylinder(h = {:.3g}, r = {}, $fn = {});", e, n, random.whole(3, 60));
    }
}

/// Leaves that reach far, at odd angles, against small parts.
TEST(FarReaching, HasAMesh) {
    std::size_t exact = 0, not_empty = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Random random(seed);
        constexpr const char* operations[] = {"difference", "intersection", "union"};
        std::vector<std::string> parts{far_part(random)};
        for (int i = random.whole(1, 3); i > 0; --i) {
            parts.push_back(small_part(random));
        }
        if (random.chance(0.5)) {
            std::swap(parts.front(), parts.back());
        }
        std::string program = fmt::format("{}() {{", operations[random.whole(0, 2)]);
        for (const std::string& part : parts) {
            program += " " + part;
        }
        program += " }";
        SCOPED_TRACE(program);
        const auto model = meshes::model_of(program);
        BooleanResult result;
        ASSERT_NO_THROW(result = csg::reference::make_mesh(model->scene, model->geometry));
        EXPECT_TRUE(result.facts.manifold);
        exact += result.method == Method::Exact ? 1 : 0;
        not_empty += result.mesh.empty() ? 0 : 1;
        const csg::Box near{glm::dvec3(-5), glm::dvec3(5)};
        EXPECT_EQ(meshes::count_wrong_points(model->scene, model->geometry, result.mesh, near, 50), 0u);
    }
    EXPECT_GT(exact, 5u);
    EXPECT_GT(not_empty, 100u);
}

/// Faces that lie on each other and cancel hold nothing and have no borders, but what meets them may cross there.
TEST(DoubledFaces, HoldNothing) {
    const std::string fan = "faces = [[0,3,2], [1,2,3], [0,4,3], [1,3,4], [0,5,4], [1,4,5], [0,2,5], [1,5,2]]); ";
    const std::string sheet = "polyhedron([[3,5,3], [3,3,4], [3,4,3], [0,0,0], [0,0,0], [0,0,0]], " + fan;
    const std::string other = "polyhedron([[3,6,3], [3,4,5], [3,3,3], [0,0,0], [0,0,0], [0,0,0]], " + fan;
    const std::string flat = "polyhedron([[4,4,0], [4,4,0], [4,4,4], [0,0,4], [4,0,0], [0,0,0]], " + fan;
    const std::pair<std::string, double> models[] = {
        {sheet + "cube([8,8,2]);", 128},
        {other + "linear_extrude(4) polygon([[6,5], [0,2], [7,3]]);", 30},
        {"difference() { cube([8,8,2]); " + sheet + "}", 128},
        {flat, 0},
    };
    for (const auto& [program, volume] : models) {
        SCOPED_TRACE(program);
        const auto model = meshes::model_of(program);
        EXPECT_NEAR(csg::reference::make_mesh(model->scene, model->geometry).facts.volume, volume, 1e-9);
        EXPECT_NEAR(by(Method::Exact, model->scene, model->geometry).facts.volume, volume, 1e-9);
    }
}

/// A leaf stands with an edge on the diagonal between two triangles of another leaf's face.
TEST(Diagonals, AreEdgesWhereAnotherLeafStandsOnThem) {
    const std::pair<const char*, double> models[] = {
        {"cube([2,2,1]); polyhedron([[0,0,1], [2,2,1], [0.5,1.5,2], [1.5,0.5,2]], [[0,1,2], [0,3,1], [0,2,3], "
         "[1,3,2]]);",
         14.0 / 3},
        {"cube([2,2,1]); polyhedron([[2,0,1], [0,2,1], [1.5,1.5,2], [0.5,0.5,2]], [[0,2,1], [0,1,3], [0,3,2], "
         "[1,2,3]]);",
         14.0 / 3},
        {"rotate_extrude(start = 0, $fn = 3) polygon([[2,5], [2,6], [0,0]]);"
         "rotate_extrude(angle = 60, start = 0, $fn = 6) polygon([[4,4], [2,5], [2,6], [0,0]]);",
         14.914881954065},  // by both methods
    };
    for (const auto& [program, volume] : models) {
        SCOPED_TRACE(program);
        const auto model = meshes::model_of(program);
        for (const Method method : {Method::Planes, Method::Exact}) {
            EXPECT_NEAR(by(method, model->scene, model->geometry).facts.volume, volume, 1e-9) << name(method);
        }
    }
}

struct File {
    const char* name;
    double volume;  ///< By either method, which agree; the first by hand.
};

class Files : public testing::TestWithParam<File> {};

TEST_P(Files, HaveAMesh) {
    std::ifstream in(std::string(CSGSCOPE_SOURCE_DIR "/tests/csg/reference/cases/") + GetParam().name);
    std::stringstream text;
    text << in.rdbuf();
    const auto model = meshes::model_of(text.str());
    for (const Method method : {Method::Planes, Method::Exact}) {
        const BooleanResult result = by(method, model->scene, model->geometry);
        EXPECT_TRUE(result.facts.manifold);
        EXPECT_NEAR(result.facts.volume, GetParam().volume, 1e-6 * GetParam().volume) << name(method);
        EXPECT_EQ(meshes::count_wrong_points(model->scene, model->geometry, result.mesh, model->geometry.box, 200), 0u);
    }
}

const File kFiles[] = {{"two_shells.scad", 850},
                       {"sheet_beside_wall.scad", 12},
                       {"noisy_wall_2_rings.scad", 7535.8313165602},
                       {"noisy_wall_11_rings.scad", 154476.346727},
                       {"noisy_vase.csg", 55241.081421059},
                       {"overlapping_spring.scad", 765.40226691295}};

INSTANTIATE_TEST_SUITE_P(Cases, Files, testing::ValuesIn(kFiles), [](const auto& info) {
    const std::string name = info.param.name;
    return name.substr(0, name.find('.'));
});

}  // namespace
