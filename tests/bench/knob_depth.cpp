// The knob of depth: its format, and where it comes from. The lists of a picture are walked as lists-cpu walks them,
// but with the depth that another renderer would have.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "csg/solid/part_order.h"
#include "goldfeather/lists_cpu/pixel_walk.h"
#include "tests/bench/knobs.h"
#include "tests/truth/ray_caster.h"

namespace bench {

namespace {

using goldfeather::Fragment;

/// How a renderer stores depth.
struct Format {
    double bits;
    bool single;                            ///< Interpolated in single precision.
    std::function<double(double)> rounded;  ///< Reversed depth to what is stored; the larger is nearer.
};

/// OpenGL's usual depth: fixed point between a near and a far plane close about the scene.
Format fixed_point(int bits, const base::View& view, const csg::Box& box) {
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 corner((i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
                                (i & 4) != 0 ? box.hi.z : box.lo.z, 1.0);
        const double distance = -(view.eye_from_world() * corner).z;
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    const double levels = std::ldexp(1.0, bits) - 1;
    return {static_cast<double>(bits), true, [=](double depth) {
                const double distance = view.distance(depth);
                const double z = view.orthographic() ? (distance - nearest) / (farthest - nearest)
                                                     : farthest / (farthest - nearest) * (1 - nearest / distance);
                return -std::round(std::clamp(z, 0.0, 1.0) * levels);
            }};
}

/// A triangle in the picture, in pixels.
struct Projected {
    std::array<glm::dvec2, 3> at;
    std::array<double, 3> depth;
    csg::LeafId leaf;
    std::uint32_t plane;
};

std::vector<Projected> project(const ui::Model& model, const base::View& view) {
    std::vector<Projected> result;
    const double scale = view.size().y / (2 * view.half_height());
    for (csg::LeafId id = 0; id < model.geometry.leaves.size(); ++id) {
        const csg::solid::PlacedLeaf& leaf = model.geometry.leaves[id];
        for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
            Projected p{{}, {}, id, leaf.planes[t].index};
            for (int k = 0; k < 3; ++k) {
                const glm::dvec3 eye(view.eye_from_world() * glm::dvec4(leaf.points[leaf.triangles[t][k]], 1.0));
                const auto i = static_cast<std::size_t>(k);
                p.at[i] =
                    glm::dvec2(eye) * (scale / (view.orthographic() ? 1.0 : -eye.z)) + 0.5 * glm::dvec2(view.size());
                p.depth[i] = view.depth(-eye.z);
            }
            result.push_back(p);
        }
    }
    return result;
}

/// The weights of the corners at a point within the triangle.
std::optional<std::array<double, 3>> weights(const Projected& t, const glm::dvec2& p) {
    const auto area = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
        return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    };
    const double whole = area(t.at[0], t.at[1], t.at[2]);
    const std::array<double, 3> w{area(p, t.at[1], t.at[2]) / whole, area(t.at[0], p, t.at[2]) / whole,
                                  area(t.at[0], t.at[1], p) / whole};
    return w[0] >= 0 && w[1] >= 0 && w[2] >= 0 ? std::optional(w) : std::nullopt;
}

template <typename Real>
double interpolated(const Projected& t, const std::array<double, 3>& w) {
    Real sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        sum += static_cast<Real>(w[i]) * static_cast<Real>(t.depth[i]);
    }
    return static_cast<double>(sum);
}

bool same(const truth::Ray& ray, std::span<const goldfeather::FoundSurface> found) {
    return std::equal(ray.surfaces.begin(), ray.surfaces.end(), found.begin(), found.end(),
                      [](const truth::Surface& expected, const goldfeather::FoundSurface& actual) {
                          return expected.leaving == actual.leaving &&
                                 std::find(expected.leaves.begin(), expected.leaves.end(), actual.leaf) !=
                                     expected.leaves.end();
                      });
}

}  // namespace

void turn_depth(const Subject& subject, std::vector<KnobRow>& rows) {
    constexpr int kSide = 256, kRays = 2000;
    const ui::Model& model = *subject.model;
    const base::View view(subject.camera, glm::ivec2(kSide), model.geometry.box.lo, model.geometry.box.hi);
    const truth::RayCaster caster(model.scene, model.geometry, view);
    const std::vector<Projected> triangles = project(model, view);
    std::vector<base::View::ExactPlaneDepth> planes;
    for (const csg::solid::Plane& plane : model.geometry.planes.planes()) {
        planes.push_back(view.exact_plane_depth(plane.normal, plane.offset));
    }
    const std::array formats{fixed_point(16, view, model.geometry.box), fixed_point(24, view, model.geometry.box),
                             Format{32, true, [](double d) { return static_cast<double>(static_cast<float>(d)); }},
                             Format{53, false, [](double d) { return d; }}};
    const goldfeather::ExpressionTree tree(model.scene);
    const std::vector<char> outside(model.geometry.leaves.size(), 0);
    const std::vector<std::uint32_t> ranks = csg::solid::ranks_of(csg::solid::part_order(model.scene, &model.geometry));
    goldfeather::PixelWalk walk(tree, model.scene, ranks, outside, outside, 0);
    std::array<std::array<int, formats.size()>, 2> wrong{};
    int decided = 0;
    for (int i = 0; i < kSide * kSide; i += (kSide * kSide / kRays) | 1) {
        const int x = i % kSide, y = i / kSide;
        const truth::Ray ray = caster.cast(x, y);
        if (!ray.decided || !ray.hit) {
            continue;
        }
        ++decided;
        const glm::dvec2 sample = glm::dvec2(x, y) + 0.5, centered = sample - 0.5 * kSide;
        for (std::size_t f = 0; f < formats.size(); ++f) {
            std::array<std::vector<Fragment>, 2> lists;
            for (const Projected& t : triangles) {
                const auto w = weights(t, sample);
                if (!w) {
                    continue;
                }
                const auto& plane = planes[t.plane];
                const double between = formats[f].single ? interpolated<float>(t, *w) : interpolated<double>(t, *w);
                const double on_plane = plane.edge_on ? between : plane.a * centered.x + plane.b * centered.y + plane.c;
                lists[0].push_back({formats[f].rounded(on_plane), t.leaf << 1, t.plane, 0});
                lists[1].push_back({formats[f].rounded(between), t.leaf << 1, t.plane, 0});
            }
            for (std::size_t source = 0; source < 2; ++source) {
                std::stable_sort(lists[source].begin(), lists[source].end(),
                                 [](const Fragment& a, const Fragment& b) { return a.depth > b.depth; });
                wrong[source][f] += same(ray, walk.walk(lists[source])) ? 0 : 1;
            }
        }
    }
    for (std::size_t source = 0; source < 2; ++source) {
        for (std::size_t f = 0; f < formats.size(); ++f) {
            rows.push_back({"depth", subject.name, source == 0 ? "of the plane" : "interpolated", formats[f].bits, 0,
                            100.0 * wrong[source][f] / std::max(decided, 1)});
        }
    }
}

}  // namespace bench
