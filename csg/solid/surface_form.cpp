#include "csg/solid/surface_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace csg::solid {

const char* name(FormKind kind) {
    static constexpr std::array<const char*, 5> kNames{"plane", "cylinder", "cone", "sphere", "torus"};
    return kNames[static_cast<std::size_t>(kind)];
}

namespace {

Plane plane_of(const Geometry& geometry, const PlacedLeaf& leaf, std::uint32_t triangle) {
    const PlaneRef ref = leaf.planes[triangle];
    const Plane& plane = geometry.planes.planes()[ref.index];
    return ref.flipped ? Plane{-plane.normal, -plane.offset} : plane;
}

std::array<glm::dvec3, 3> corners_of(const PlacedLeaf& leaf, std::uint32_t triangle) {
    const glm::uvec3& t = leaf.triangles[triangle];
    return {leaf.points[t.x], leaf.points[t.y], leaf.points[t.z]};
}

/// How far a point is from the surface that a form is.
double off(const SurfaceForm& form, const glm::dvec3& p) {
    const glm::dvec3 to = p - form.point;
    const double along = glm::dot(to, form.direction);
    const double across = glm::length(to - along * form.direction);
    switch (form.kind) {
        case FormKind::Plane:
            return std::abs(along);
        case FormKind::Cylinder:
            return std::abs(across - form.radius);
        case FormKind::Cone:
            return std::abs(across * std::cos(form.half_angle) - along * std::sin(form.half_angle));
        case FormKind::Sphere:
            return std::abs(glm::length(to) - form.radius);
        case FormKind::Torus:
            return std::abs(std::hypot(across - form.ring_radius, along) - form.radius);
    }
    return 0;
}

/// How wide the triangle is across the form's axis; of spheres, how large; of a torus, around its tube.
double width_of(const SurfaceForm& form, const std::array<glm::dvec3, 3>& corners) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 to = corners[(i + 1) % 3] - corners[i];
        const glm::dvec3 across = to - glm::dot(to, form.direction) * form.direction;
        most = std::max(most, glm::length(form.kind == FormKind::Sphere ? to : across));
    }
    return most;
}

/// Across a torus, at the point of it that is next to `p`.
glm::dvec3 torus_normal(const SurfaceForm& form, const glm::dvec3& p) {
    const glm::dvec3 to = p - form.point;
    const glm::dvec3 across = to - glm::dot(to, form.direction) * form.direction;
    return glm::normalize(to - form.ring_radius * glm::normalize(across));
}

/// Is the triangle one of the facets that stand for the shape, and not a cap or a chord of it?
bool is_facet_of(const RoundShape& shape, const std::array<glm::dvec3, 3>& corners, const glm::dvec3& normal,
                 double tolerance) {
    const SurfaceForm& form = shape.form;
    const double facing = std::abs(glm::dot(normal, form.direction));
    constexpr double kCap = 1 - 1e-9;
    if (form.kind == FormKind::Cylinder ? facing > 1e-6 : form.kind == FormKind::Cone && facing > kCap) {
        return false;
    }
    constexpr double kAlong = 0.5;
    if (form.kind == FormKind::Torus &&
        std::abs(glm::dot(normal, torus_normal(form, (corners[0] + corners[1] + corners[2]) / 3.0))) < kAlong) {
        return false;  // The end of a turn that is not whole.
    }
    constexpr double kRoom = 1 + 1e-6;
    return std::all_of(corners.begin(), corners.end(),
                       [&](const glm::dvec3& p) { return off(form, p) <= tolerance; }) &&
           width_of(form, corners) <= shape.step * kRoom + tolerance;
}

/// Triangles of one group around one of them, facet by facet: those that share edges.
class Neighborhood {
  public:
    explicit Neighborhood(const PlacedLeaf& leaf) : leaf_(leaf) {
        for (std::uint32_t i = 0; i < leaf.triangles.size(); ++i) {
            for (int k = 0; k < 3; ++k) {
                edges_.push_back({key(leaf.triangles[i], k), i});
            }
        }
        std::sort(edges_.begin(), edges_.end());
    }

    /// The facet of the triangle and, twice, the smooth facets around what is there.
    [[nodiscard]] std::vector<std::uint32_t> around(std::uint32_t triangle) const {
        std::vector<std::uint32_t> found = grown({triangle});
        for (int ring = 0; ring < 2; ++ring) {
            found = grown(grown_once(found));
        }
        return found;
    }

  private:
    using Key = std::pair<std::uint32_t, std::uint32_t>;
    [[nodiscard]] static Key key(const glm::uvec3& t, int k) { return std::minmax({t[k], t[(k + 1) % 3]}); }

    template <typename Visit>
    void for_neighbors(std::uint32_t triangle, const Visit& visit) const {
        for (int k = 0; k < 3; ++k) {
            const Key wanted = key(leaf_.triangles[triangle], k);
            for (auto at = std::lower_bound(edges_.begin(), edges_.end(), std::pair(wanted, std::uint32_t{0}));
                 at != edges_.end() && at->first == wanted; ++at) {
                if (at->second != triangle && smooth(triangle, at->second)) {
                    visit(at->second);
                }
            }
        }
    }
    [[nodiscard]] bool smooth(std::uint32_t a, std::uint32_t b) const {
        const auto groups = groups_of(leaf_);
        return same_plane(a, b) || (!groups.empty() && smooth_between(groups[a], groups[b]));
    }
    [[nodiscard]] bool same_plane(std::uint32_t a, std::uint32_t b) const {
        return leaf_.planes[a].index == leaf_.planes[b].index;
    }
    [[nodiscard]] std::vector<std::uint32_t> grown_once(const std::vector<std::uint32_t>& of) const {
        std::set<std::uint32_t> all(of.begin(), of.end());
        for (const std::uint32_t triangle : of) {
            for_neighbors(triangle, [&](std::uint32_t other) { all.insert(other); });
        }
        return {all.begin(), all.end()};
    }
    /// Until whole facets are in it.
    [[nodiscard]] std::vector<std::uint32_t> grown(std::vector<std::uint32_t> open) const {
        std::set<std::uint32_t> all(open.begin(), open.end());
        while (!open.empty()) {
            const std::uint32_t triangle = open.back();
            open.pop_back();
            for_neighbors(triangle, [&](std::uint32_t other) {
                if (same_plane(triangle, other) && all.insert(other).second) {
                    open.push_back(other);
                }
            });
        }
        return {all.begin(), all.end()};
    }

    const PlacedLeaf& leaf_;
    std::vector<std::pair<Key, std::uint32_t>> edges_;
};

FacetPatch patch_of(const Geometry& geometry, const PlacedLeaf& leaf, std::uint32_t triangle) {
    FacetPatch patch;
    std::set<std::uint32_t> points, planes;
    for (const std::uint32_t i : Neighborhood(leaf).around(triangle)) {
        for (int k = 0; k < 3; ++k) {
            if (points.insert(leaf.triangles[i][k]).second) {
                patch.corners.push_back(leaf.points[leaf.triangles[i][k]]);
            }
        }
        if (planes.insert(leaf.planes[i].index).second) {
            patch.normals.push_back(plane_of(geometry, leaf, i).normal);
            patch.on_facets.push_back(corners_of(leaf, i)[0]);
        }
    }
    return patch;
}

/// Is the triangle part of a surface that bends?
bool bends(const PlacedLeaf& leaf, std::uint32_t triangle) {
    const auto groups = groups_of(leaf);
    return !groups.empty() && groups[triangle].bend() > 0;
}

bool is_primitive(const Tree& tree, const LeafInstance& leaf) {
    return leaf.node != kNoNode && tree.node(leaf.node).operation == Operation::Leaf &&
           (std::holds_alternative<Cylinder>(tree.shape(leaf.node)) ||
            std::holds_alternative<Sphere>(tree.shape(leaf.node)));
}

}  // namespace

SurfaceForm form_of(const Tree& tree, const Scene& scene, const Geometry& geometry, LeafId id, std::uint32_t triangle) {
    const PlacedLeaf& leaf = geometry.leaves[id];
    const Plane plane = plane_of(geometry, leaf, triangle);
    const auto corners = corners_of(leaf, triangle);
    SurfaceForm flat;
    flat.direction = plane.normal;
    flat.point = (corners[0] + corners[1] + corners[2]) / 3.0;
    flat.point += (plane.offset - glm::dot(plane.normal, flat.point)) * plane.normal;

    std::string uneven;
    const std::vector<RoundShape> shapes = round_shapes(tree, scene.leaves[id], uneven);
    if (is_primitive(tree, scene.leaves[id])) {  // Facets may have been cut: their corners tell nothing.
        if (!bends(leaf, triangle)) {
            return flat;
        }
        if (!shapes.empty()) {
            return shapes.front().form;
        }
        flat.remark = uneven;
        return flat;
    }
    const double tolerance = std::max(4 * geometry.planes.tolerance(), 1e-9 * geometry.box.diagonal());
    for (const RoundShape& shape : shapes) {
        if (is_facet_of(shape, corners, plane.normal, tolerance)) {
            return shape.form;
        }
    }
    if (!bends(leaf, triangle)) {
        return flat;
    }
    if (const auto fitted = fitted_form(patch_of(geometry, leaf, triangle))) {
        return *fitted;
    }
    flat.remark = uneven.empty() ? "a facet of a bent surface, which has no radius there" : uneven;
    return flat;
}

}  // namespace csg::solid
