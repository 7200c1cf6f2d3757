#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <unordered_map>

#include "csg/reference/box_pairs.h"
#include "goldfeather/surface_table.h"
#include "tests/edges/edge_points.h"

namespace edges {
namespace {

using csg::reference::Mesh;

constexpr std::uint32_t kNone = 0xffffffffU;

/// The table of smooth groups, as shaders read it.
struct GroupTable {
    using uint = std::uint32_t;
    using Words = const std::vector<std::uint32_t>&;
    Words group_words;

    [[nodiscard]] static std::uint32_t max(std::uint32_t a, std::uint32_t b) { return std::max(a, b); }
    [[nodiscard]] static std::uint32_t min(std::uint32_t a, std::uint32_t b) { return std::min(a, b); }
#include "layers/smooth_groups.glsl"
};

/// A facet of the mesh: a triangle with what it is of.
struct Facet {
    glm::dvec3 normal{0};
    double offset = 0;
    std::uint32_t plane = kNone;
    std::uint32_t leaf = 0;
};

class Truth {
  public:
    Truth(const ui::Model& model, const Mesh& mesh, const base::View& view)
        : model_(model),
          mesh_(mesh),
          view_(view),
          table_(goldfeather::surface_table(model.scene, model.geometry)),
          groups_{table_->groups},
          boxes_(csg::reference::triangle_boxes(mesh.points, mesh.triangles)),
          tree_(boxes_) {}

    std::vector<Point> points() {
        find_facets();
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first;
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t a = mesh_.triangles[t][i], b = mesh_.triangles[t][(i + 1) % 3];
                const auto [other, fresh] = first.try_emplace(std::minmax(a, b), t);
                if (!fresh) {
                    add(a, b, other->second, t);
                }
            }
        }
        return std::move(points_);
    }

  private:
    void find_facets() {
        std::vector<std::vector<std::uint32_t>> planes_of(model_.geometry.leaves.size());
        for (std::size_t l = 0; l < planes_of.size(); ++l) {
            for (const csg::solid::PlaneRef& plane : model_.geometry.leaves[l].planes) {
                planes_of[l].push_back(plane.index);
            }
            std::sort(planes_of[l].begin(), planes_of[l].end());
        }
        std::vector<std::uint32_t> found;
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            const glm::uvec3& c = mesh_.triangles[t];
            const glm::dvec3 &p = mesh_.points[c.x], &q = mesh_.points[c.y], &r = mesh_.points[c.z];
            const csg::solid::Plane plane = csg::solid::plane_through(p, q, r);
            Facet& facet = facets_.emplace_back(Facet{plane.normal, plane.offset, kNone, mesh_.sources[t]});
            found.clear();
            model_.geometry.planes.find_all(plane, p, q, r, found);
            const auto& own = planes_of[facet.leaf];
            for (const std::uint32_t i : found) {
                if (std::binary_search(own.begin(), own.end(), i)) {
                    facet.plane = i;
                    break;
                }
            }
        }
    }

    [[nodiscard]] bool front(const Facet& facet) const {
        return view_.orthographic() ? glm::dot(facet.normal, toward_eye({})) > 0
                                    : glm::dot(facet.normal, view_.camera().eye()) > facet.offset;
    }

    /// Not of unit length.
    [[nodiscard]] glm::dvec3 toward_eye(const glm::dvec3& p) const {
        const glm::dmat4& m = view_.eye_from_world();
        return view_.orthographic() ? glm::dvec3(m[0][2], m[1][2], m[2][2]) : view_.camera().eye() - p;
    }

    [[nodiscard]] bool bends(const Facet& a, const Facet& b) {
        constexpr double kLeast = 3 * std::numbers::pi / 180;
        if (a.plane == kNone || b.plane == kNone || a.plane == b.plane) {
            return false;
        }
        const double angle = std::acos(std::clamp(glm::dot(a.normal, b.normal), -1.0, 1.0));
        const auto m = groups_.groups_of(a.plane, a.leaf), n = groups_.groups_of(b.plane, b.leaf);
        if (a.leaf == b.leaf) {
            return angle > kLeast && !groups_.one_surface(m, n);
        }
        return angle > std::max(kLeast, 0.5 * static_cast<double>(groups_.bend_of(m) + groups_.bend_of(n)) + 1e-3);
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t s, std::uint32_t t) {
        const Facet &m = facets_[s], &n = facets_[t];
        if (m.plane != n.plane && front(m) != front(n)) {
            sample(a, b, Kind::Silhouette);
        } else if (bends(m, n)) {
            sample(a, b, Kind::Crease);
        } else if (!(model_.scene.leaves[m.leaf].color == model_.scene.leaves[n.leaf].color)) {
            sample(a, b, Kind::Border);
        }
    }

    void sample(std::uint32_t from, std::uint32_t to, Kind kind) {
        const glm::dvec3 &a = mesh_.points[from], &b = mesh_.points[to];
        const double length = glm::length(project(b) - project(a));
        const auto steps = static_cast<int>(std::clamp(std::ceil(2 * length), 1.0, 1e5));
        for (int i = 0; i < steps; ++i) {
            const glm::dvec3 p = a + (b - a) * ((i + 0.5) / steps);
            const glm::dvec2 at = project(p);
            const glm::dvec2 size(view_.size());
            // Shorter pieces count less: by chance, but always by the same.
            if (at.x < 1 || at.y < 1 || at.x > size.x - 1 || at.y > size.y - 1 || !counts(2 * length / steps)) {
                continue;
            }
            points_.push_back({at, kind, hidden(p)});
        }
    }

    /// Adds up shares of points; true whenever there is a whole one.
    bool counts(double share) {
        sum_ += share;
        if (sum_ < 1) {
            return false;
        }
        sum_ -= std::floor(sum_);
        return true;
    }

    [[nodiscard]] glm::dvec2 project(const glm::dvec3& p) const {
        const glm::dvec4 clip = view_.clip_from_world() * glm::dvec4(p, 1);
        return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(view_.size()) + view_.jitter();
    }

    [[nodiscard]] bool hidden(const glm::dvec3& p) const {
        const glm::dvec3 way = glm::normalize(toward_eye(p));
        const double least = 1e-6 * model_.geometry.box.diagonal();
        return !tree_.along(p, way, [&](std::uint32_t i) {
            const glm::uvec3& t = mesh_.triangles[i];
            const glm::dvec3 &a = mesh_.points[t.x], u = mesh_.points[t.y] - a, v = mesh_.points[t.z] - a;
            const glm::dvec3 h = glm::cross(way, v);
            const double determinant = glm::dot(u, h);
            if (determinant == 0) {
                return true;
            }
            const glm::dvec3 s = p - a, q = glm::cross(s, u);
            const double x = glm::dot(s, h) / determinant, y = glm::dot(way, q) / determinant;
            return x < 0 || y < 0 || x + y > 1 || glm::dot(v, q) / determinant < least;
        });
    }

    const ui::Model& model_;
    const Mesh& mesh_;
    const base::View& view_;
    std::shared_ptr<layers::SurfaceTable> table_;
    GroupTable groups_;
    std::vector<csg::Box> boxes_;
    csg::reference::BoxTree tree_;
    std::vector<Facet> facets_;
    std::vector<Point> points_;
    double sum_ = 0;
};

}  // namespace

std::vector<Point> true_points(const ui::Model& model, const Mesh& mesh, const base::View& view) {
    return Truth(model, mesh, view).points();
}

}  // namespace edges
