#include "tests/outlines/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "csg/solid/extrude.h"
#include "csg/solid/indexed_outline.h"
#include "csg/solid/triangulate_region.h"
#include "tests/csg/solid/mesh_volume.h"
#include "tests/outlines/even_odd.h"

namespace outlines {
namespace {

using namespace csg::solid;

constexpr double kPi = 3.14159265358979323846;

/// How often the mesh winds around p, by a ray upwards that is a little askew.
int winding(const Solid& solid, const glm::dvec3& p) {
    const glm::dvec3 way(0.0123456789, 0.0234567891, 1);
    int sum = 0;
    for (const glm::uvec3& t : solid.triangles) {
        const glm::dvec3 a = solid.points[t.x] - p, b = solid.points[t.y] - p, c = solid.points[t.z] - p;
        const double u = glm::dot(way, glm::cross(a, b)), v = glm::dot(way, glm::cross(b, c)),
                     w = glm::dot(way, glm::cross(c, a));
        const bool front = u > 0 && v > 0 && w > 0, back = u < 0 && v < 0 && w < 0;
        if ((front || back) && glm::dot(a, glm::cross(b, c)) * (u + v + w) > 0) {
            sum += front ? 1 : -1;
        }
    }
    return sum;
}

class Checks {
  public:
    Checks(const std::vector<Loop>& loops, std::uint64_t seed) : loops_(loops), random_(seed) {
        csg::Polygon polygon;
        polygon.has_paths = true;
        for (const Loop& loop : loops) {
            auto& path = polygon.paths.emplace_back();
            for (const glm::dvec2& p : loop) {
                path.push_back(static_cast<std::uint32_t>(polygon.points.size()));
                polygon.points.push_back(p);
            }
        }
        outline_ = make_outline(polygon);
        box_ = bounds_of(loops);
        size_ = std::max(box_.diagonal(), 1e-300);
        reach_ = size_ + glm::length(box_.center());
        moments_ = even_odd_moments(loops);
    }

    std::string run() {
        if (!is_region(outline_)) {
            return "the outline breaks the rule";
        }
        expect("area", outline_.area(), moments_.area, reach_ * size_);
        check_triangles();
        check_extrusions();
        check_revolutions();
        check_offsets();
        return problem_;
    }

  private:
    double random() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    void expect(const char* what, double is, double right, double scale) {
        if (!(std::abs(is - right) <= 1e-9 * scale) && problem_.empty()) {
            problem_ = fmt::format("{}: {} instead of {}", what, is, right);
        }
    }
    void expect(bool good, const std::string& what) {
        if (!good && problem_.empty()) {
            problem_ = what;
        }
    }

    void check_triangles() {
        const IndexedOutline indexed = index_corners(outline_);
        double sum = 0, all = 0;
        for (const glm::uvec3& t : triangulate_region(indexed)) {
            const double a = turn(indexed.points[t.x], indexed.points[t.y], indexed.points[t.z]) / 2;
            sum += a;
            all += std::abs(a);
        }
        expect("area of triangles", sum, moments_.area, reach_ * size_);
        expect("area of triangles, all positive", all, moments_.area, reach_ * size_);
    }

    void check_volume(const char* what, const Solid& solid, double right, double scale) {
        expect(solid.closed || solid.triangles.empty(), fmt::format("{}: not closed", what));
        expect(what, test::mesh_volume(solid.points, solid.triangles), right, scale);
    }

    /// Points of the plane of the outline, placed by `place`.
    template <typename Place>
    void check_points(const char* what, const Solid& solid, Place&& place, int sign) {
        for (int i = 0; i < 12; ++i) {
            const glm::dvec2 p(box_.lo.x + random() * (box_.hi.x - box_.lo.x),
                               box_.lo.y + random() * (box_.hi.y - box_.lo.y));
            const auto inside = is_inside(loops_, p, 1e-6 * size_ + 1e-9 * reach_);
            if (!inside) {
                continue;
            }
            const int w = winding(solid, place(p));
            expect(w == (*inside ? sign : 0), fmt::format("{}: winds {} times around ({}, {})", what, w, p.x, p.y));
        }
    }

    void check_extrusions() {
        const double area = moments_.area, scale = reach_ * reach_ * reach_;
        csg::LinearExtrude how;
        how.height = size_;
        auto solid = linear_extrude(outline_, how);
        check_volume("extruded", *solid, area * size_, scale);
        check_points(
            "extruded", *solid, [&](const glm::dvec2& p) { return glm::dvec3(p, 0.4 * size_); }, 1);
        how.scale = {0.5, 0.5};
        solid = linear_extrude(outline_, how);
        check_volume("scaled", *solid, area * size_ * (1 + 0.5 + 0.25) / 3, scale);
        check_points(
            "scaled", *solid, [&](const glm::dvec2& p) { return glm::dvec3(0.75 * p, 0.5 * size_); }, 1);
        how.scale = {0, 0};
        check_volume("to a point", *linear_extrude(outline_, how), area * size_ / 3, scale);
        // Each wall of a slice is two triangles instead of a bent surface: between them lies a tetrahedron of an edge
        // below and the one above it, turned by a slice's angle. Half of it, half of the walls: a bound on the error.
        how.scale = {1, 1};
        how.twist = 30;
        how.slices = 60;
        solid = linear_extrude(outline_, how);
        double squares = 0;
        for (const Loop& loop : outline_.loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                squares += std::pow(glm::distance(loop[i], loop[(i + 1) % loop.size()]), 2);
            }
        }
        const double slice = how.twist.value_or(0) / 60 * kPi / 180;
        check_volume("twisted", *solid, area * size_, scale + 1e9 * size_ * squares * slice / 6);
        const double turned = -15 * kPi / 180;
        check_points(
            "twisted", *solid,
            [&](const glm::dvec2& p) {
                return glm::dvec3(std::cos(turned) * p.x - std::sin(turned) * p.y,
                                  std::sin(turned) * p.x + std::cos(turned) * p.y, 0.5 * size_ + 1e-13 * size_);
            },
            1);
    }

    void check_revolutions() {
        // Beside the axis or touching it, on either side.
        const bool touches = random_() % 2 == 0, mirrored = random_() % 2 == 0;
        const double shift = (touches ? 0 : 0.3 * size_) - box_.lo.x;
        const double mirror = mirrored ? -1 : 1;
        glm::dmat4 matrix(1.0);
        matrix[0][0] = mirror;
        matrix[3][0] = mirror * shift;
        const Outline moved = transform(outline_, matrix);
        expect(is_region(moved), "moved: the outline breaks the rule");
        const double moment = moments_.x + shift * moments_.area, scale = reach_ * reach_ * reach_;
        csg::RotateExtrude how;
        how.angle = 360;
        how.start = 0;
        how.fineness.fn = 3 + static_cast<double>(random_() % 9);
        // OpenSCAD turns what is smaller than its grid in three steps.
        const double fn = circle_segments(shift + box_.hi.x, how.fineness), step = 2 * kPi / fn;
        // Along a ring of corners the section is the outline. We look a hair beyond it, so that no ray meets the
        // corners; between two rings surfaces are chords, so that the section there is nearer to the axis in
        // proportion.
        const auto beyond = [&](double ring, double to_next) {
            const double hair = 1e-9 * to_next, nearer = std::cos(to_next / 2) / std::cos(to_next / 2 - hair);
            return [=](const glm::dvec2& p) {
                const double r = mirror * (p.x + shift) * nearer;
                return glm::dvec3(r * std::cos(ring + hair), r * std::sin(ring + hair), p.y);
            };
        };
        auto solid = rotate_extrude(moved, how);
        check_volume("revolved", *solid, fn * std::sin(step) * moment, scale * 8);
        check_points("revolved", *solid, beyond(step, step), 1);
        how.angle = random_() % 2 == 0 ? 100 : -200;
        solid = rotate_extrude(moved, how);
        const double steps = std::max(1.0, std::ceil(fn * std::abs(how.angle) / 360));
        const double part = std::abs(how.angle) * kPi / 180 / steps;
        if (part < 0.99 * kPi) {
            check_volume("revolved in part", *solid, steps * std::sin(part) * moment, scale * 8);
            check_points("revolved in part", *solid, beyond(0, how.angle < 0 ? -part : part), 1);
        }
    }

    /// Points nearer to the region than the distance are inside, those farther away outside.
    void check_offsets() {
        csg::Offset how;
        how.fineness.fn = 64;
        for (const double part : {0.06, -0.03}) {
            how.distance = part * size_;
            const Outline moved = offset(outline_, how);
            expect(is_region(moved), "offset: the outline breaks the rule");
            const double margin = std::abs(how.distance) * 0.002 + 1e-6 * size_ + 1e-9 * reach_;
            for (int i = 0; i < 12; ++i) {
                const glm::dvec2 p(box_.lo.x + (1.3 * random() - 0.15) * (box_.hi.x - box_.lo.x),
                                   box_.lo.y + (1.3 * random() - 0.15) * (box_.hi.y - box_.lo.y));
                const auto in_region = is_inside(outline_.loops, p, margin),
                           in_moved = is_inside(moved.loops, p, margin);
                if (!in_region || !in_moved || outline_.empty()) {
                    continue;
                }
                const double depth = (*in_region ? 1 : -1) * distance_to_edges(outline_.loops, p);
                if (std::abs(depth + how.distance) > margin) {
                    expect(*in_moved == (depth > -how.distance),
                           fmt::format("offset by {}: wrong at ({}, {})", how.distance, p.x, p.y));
                }
            }
        }
    }

    const std::vector<Loop>& loops_;
    std::mt19937_64 random_;
    Outline outline_;
    csg::Box box_;
    double size_ = 1, reach_ = 1;
    Moments moments_;
    std::string problem_;
};

}  // namespace

std::string problem_of(const std::vector<Loop>& loops, std::uint64_t seed) {
    return Checks(loops, seed).run();
}

}  // namespace outlines
