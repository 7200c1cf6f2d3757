// Minkowski sums of random operands against membership, decided for single points and without any sum: x is in A + B
// exactly where A meets x - B. More of them with CSGSCOPE_MINKOWSKI_SEEDS=1000, from CSGSCOPE_MINKOWSKI_FIRST on.
#include <gtest/gtest.h>

#include <cstdlib>

#include "csg/reference/components.h"
#include "csg/solid/winding_number.h"
#include "tests/csg/reference/meshes.h"
#include "tests/csg/reference/random_operands.h"

namespace {

using csg::Box;
using csg::reference::Mesh;

bool inside(const Mesh& mesh, const glm::dvec3& point) {
    return csg::solid::winding_number(mesh.points, mesh.triangles, point) != 0;
}

Box box_of(const Mesh& mesh, const glm::uvec3& t) {
    Box box;
    for (int k = 0; k < 3; ++k) {
        box = enclose(box, mesh.points[t[k]]);
    }
    return box;
}

/// Moeller and Trumbore 1997.
bool segment_meets(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& a, const glm::dvec3& b,
                   const glm::dvec3& c) {
    const glm::dvec3 d = to - from, u = b - a, v = c - a, p = glm::cross(d, v);
    const double determinant = glm::dot(u, p);
    if (determinant == 0) {
        return false;
    }
    const glm::dvec3 s = from - a, q = glm::cross(s, u);
    const double x = glm::dot(s, p) / determinant, y = glm::dot(d, q) / determinant, t = glm::dot(v, q) / determinant;
    return x >= 0 && y >= 0 && x + y <= 1 && t >= 0 && t <= 1;
}

/// Two closed surfaces that cross have an edge of one through a face of the other.
class Membership {
  public:
    Membership(const Mesh& a, const Mesh& b) : a_(a), b_(b), components_a_(starts(a)), components_b_(starts(b)) {}

    bool operator()(const glm::dvec3& x) const {
        Mesh moved = b_;
        for (glm::dvec3& p : moved.points) {
            p = x - p;
        }
        const auto in = [](const Mesh& mesh, const std::vector<glm::dvec3>& points) {
            return std::any_of(points.begin(), points.end(), [&](const glm::dvec3& p) { return inside(mesh, p); });
        };
        std::vector<glm::dvec3> starts_b;
        for (const glm::dvec3& p : components_b_) {
            starts_b.push_back(x - p);
        }
        return in(moved, components_a_) || in(a_, starts_b) || cross(a_, moved);
    }

  private:
    static std::vector<glm::dvec3> starts(const Mesh& mesh) {
        std::vector<glm::dvec3> points;
        for (const Mesh& component : csg::reference::components_of(mesh)) {
            points.push_back(component.points[0]);
        }
        return points;
    }

    static bool cross(const Mesh& a, const Mesh& b) {
        for (const glm::uvec3& s : a.triangles) {
            const Box box = box_of(a, s);
            for (const glm::uvec3& t : b.triangles) {
                if (intersect(box, box_of(b, t)).empty()) {
                    continue;
                }
                for (int k = 0; k < 3; ++k) {
                    if (segment_meets(a.points[s[k]], a.points[s[(k + 1) % 3]], b.points[t.x], b.points[t.y],
                                      b.points[t.z]) ||
                        segment_meets(b.points[t[k]], b.points[t[(k + 1) % 3]], a.points[s.x], a.points[s.y],
                                      a.points[s.z])) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    const Mesh &a_, &b_;
    std::vector<glm::dvec3> components_a_, components_b_;
};

class Points {
  public:
    explicit Points(std::mt19937_64& random) : random_(random) {}

    glm::dvec3 in_box(const Box& box) { return box.lo + box.size() * glm::dvec3(number(), number(), number()); }

    /// On one of the triangles, `height` before it.
    glm::dvec3 near_surface(const Mesh& mesh, double height) {
        const std::size_t i = std::uniform_int_distribution<std::size_t>(0, mesh.triangles.size() - 1)(random_);
        const glm::uvec3& t = mesh.triangles[i];
        double u = number(), v = number();
        if (u + v > 1) {
            u = 1 - u, v = 1 - v;
        }
        const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double length = glm::length(normal);
        return a + u * (b - a) + v * (c - a) + (length > 0 ? height / length * normal : glm::dvec3(0.0));
    }

    double number() { return std::uniform_real_distribution<double>(0, 1)(random_); }

  private:
    std::mt19937_64& random_;
};

std::uint64_t setting(const char* name, std::uint64_t otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

void check_sum(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const std::string a = random_operands::general(random);
    const std::string b = seed % 2 == 0 ? random_operands::convex(random) : random_operands::general(random);
    const std::string program = "minkowski() { union() { " + a + " } union() { " + b + " } }";
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + program);
    const Mesh left = ui::make_mesh(*meshes::model_of(a)).mesh, right = ui::make_mesh(*meshes::model_of(b)).mesh;
    if (left.empty() || right.empty()) {
        return;
    }
    Mesh sum;
    ASSERT_NO_THROW(sum = ui::make_mesh(*meshes::model_of(program)).mesh);
    ASSERT_FALSE(sum.empty());
    const csg::reference::MeshFacts facts = csg::reference::facts(sum);
    EXPECT_TRUE(facts.manifold);
    const Membership member(left, right);
    Points points(random);
    const double height = 1e-5 * facts.box.diagonal();
    Box around{facts.box.lo - height, facts.box.hi + height};
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 x =
            i % 3 == 0 ? points.in_box(around) : points.near_surface(sum, i % 3 == 1 ? height : -height);
        EXPECT_EQ(inside(sum, x), member(x)) << "at " << x.x << " " << x.y << " " << x.z;
        const glm::dvec3 p = points.near_surface(left, -0.1 * height), q = points.near_surface(right, -0.1 * height);
        if (inside(left, p) && inside(right, q)) {
            EXPECT_TRUE(inside(sum, p + q));
        }
    }
}

TEST(RandomMinkowski, HoldsWhatMembershipSays) {
    const std::uint64_t first = setting("CSGSCOPE_MINKOWSKI_FIRST", 0);
    const std::uint64_t count = setting("CSGSCOPE_MINKOWSKI_SEEDS", 60);
    for (std::uint64_t seed = first; seed < first + count && !testing::Test::HasFatalFailure(); ++seed) {
        check_sum(seed);
    }
}

}  // namespace
