#include "csg/reference/patch_surface.h"

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "base/stop.h"
#include "csg/reference/disjoint_sets.h"
#include "csg/reference/face_planes.h"
#include "csg/reference/flat_areas.h"
#include "csg/reference/manifold.h"
#include "csg/reference/plane_cells.h"
#include "csg/reference/self_intersection.h"

namespace csg::reference {
namespace {

/// As for other results (boolean.cpp), of the diagonal.
constexpr double kCrossing = 1e-8;
/// How far before a patch it is asked what is there, in tolerances of planes.
constexpr double kBefore = 64;

/// The patches as one leaf.
struct Patches {
    explicit Patches(const Mesh& mesh) : tolerance(solid::coincidence_tolerance(largest_coordinate(mesh.points))) {
        solid::PlaneTable table(tolerance);
        auto shape = std::make_shared<solid::Solid>();
        shape->closed = true;
        leaf.solid = std::move(shape);
        leaf.points = mesh.points;
        leaf.triangles = mesh.triangles;
        leaf.planes = face_planes(mesh.points, mesh.triangles, table);
        for (const glm::dvec3& p : mesh.points) {
            leaf.box = enclose(leaf.box, p);
        }
        planes = table.planes();
    }
    double tolerance;
    solid::PlacedLeaf leaf;
    std::vector<solid::Plane> planes;
};

class PatchSurface {
  public:
    PatchSurface(const Mesh& mesh, const std::function<bool(const glm::dvec3&)>& inside, const std::stop_token& stop)
        : patches_(mesh),
          group_{{&patches_.leaf}, patches_.planes, patches_.leaf.box},
          rule_(group_),
          content_(collect_segments(group_, rule_, stop)),
          inside_(inside),
          stop_(stop) {}

    Mesh make() {
        split_segments(content_, stop_);
        make_all_cells();
        join_cells();
        ask();
        Mesh mesh;
        std::vector<glm::dvec3> normals, kinds;
        for (std::size_t c = 0; c < cells_.size(); ++c) {
            if (kept_[pieces_.find(static_cast<std::uint32_t>(c))] == 0) {
                continue;
            }
            const Cell& cell = cells_[c];
            const glm::dvec3 normal = normal_of(cell);
            for (glm::uvec3 t : cell.triangles) {
                if (!cell.up) {
                    std::swap(t.y, t.z);
                }
                mesh.triangles.push_back(t);
                mesh.sources.push_back(2 * cell.plane + (cell.up ? 1 : 0));
                normals.push_back(normal);
            }
        }
        for (const PlaneContent& plane : content_.planes) {
            kinds.push_back(-plane.plane.normal);
            kinds.push_back(plane.plane.normal);
        }
        mesh.points = content_.points.points();
        separate_sheets(mesh, std::move(normals));
        merge_flat_areas(mesh, kinds, stop_);
        mesh.sources.assign(mesh.triangles.size(), 0);
        check_surface(mesh, stop_);
        return mesh;
    }

  private:
    struct Cell {
        std::uint32_t plane;  ///< Of the content.
        bool up;              ///< Faces as the plane does.
        std::vector<glm::uvec3> triangles;
    };

    [[nodiscard]] glm::dvec3 normal_of(const Cell& cell) const {
        return content_.planes[cell.plane].plane.normal * (cell.up ? 1.0 : -1.0);
    }

    void make_all_cells() {
        for (std::uint32_t p = 0; p < content_.planes.size(); ++p) {
            base::end_if_asked(stop_);
            if (content_.planes[p].segments.empty()) {
                continue;
            }
            PlaneCells made = make_cells(content_, content_.planes[p], rule_);
            const auto first = static_cast<std::uint32_t>(cells_.size());
            for (PlaneCells::Cell& cell : made.cells) {
                cells_.push_back({p, cell.covers[0].count > 0, std::move(cell.triangles)});
            }
            for (PlaneCells::Side side : made.sides) {
                side.cell += first;
                sides_.push_back(side);
            }
        }
    }

    /// Across an edge of two cells a piece goes on; with a cell that has no neighbor, or one that faces the other way,
    /// the solid is on both sides of all of it.
    void join_cells() {
        pieces_ = DisjointSets(cells_.size());
        std::sort(sides_.begin(), sides_.end(), [](const PlaneCells::Side& a, const PlaneCells::Side& b) {
            return std::tie(a.lo, a.hi, a.cell, a.left) < std::tie(b.lo, b.hi, b.cell, b.left);
        });
        std::vector<std::uint32_t> ends;
        for (std::size_t i = 0, end; i < sides_.size(); i = end) {
            for (end = i + 1; end < sides_.size() && sides_[end].lo == sides_[i].lo && sides_[end].hi == sides_[i].hi;
                 ++end) {
            }
            if (end - i == 1) {
                ends.push_back(sides_[i].cell);
            } else if (end - i == 2) {
                const auto runs_up = [&](const PlaneCells::Side& side) { return side.left == cells_[side.cell].up; };
                if (runs_up(sides_[i]) != runs_up(sides_[i + 1])) {
                    pieces_.unite(sides_[i].cell, sides_[i + 1].cell);
                } else {
                    ends.push_back(sides_[i].cell);
                    ends.push_back(sides_[i + 1].cell);
                }
            }
        }
        kept_.assign(cells_.size(), 1);
        for (const std::uint32_t cell : ends) {
            kept_[pieces_.find(cell)] = 0;
        }
    }

    /// Of each piece that ends nowhere, before the middle of its largest triangle.
    void ask() {
        struct Largest {
            double area2 = -1;
            glm::dvec3 before{0.0};
        };
        std::vector<Largest> largest(cells_.size());
        for (std::uint32_t c = 0; c < cells_.size(); ++c) {
            const std::uint32_t piece = pieces_.find(c);
            if (kept_[piece] == 0) {
                continue;
            }
            for (const glm::uvec3& t : cells_[c].triangles) {
                const glm::dvec3 &p = content_.points[t.x], &q = content_.points[t.y], &r = content_.points[t.z];
                const glm::dvec3 across = glm::cross(q - p, r - p);
                if (const double area2 = glm::dot(across, across); area2 > largest[piece].area2) {
                    largest[piece] = {area2, (p + q + r) / 3.0 + normal_of(cells_[c]) * (kBefore * patches_.tolerance)};
                }
            }
        }
        for (std::uint32_t c = 0; c < cells_.size(); ++c) {
            base::end_if_asked(stop_);
            if (largest[c].area2 >= 0 && inside_(largest[c].before)) {
                kept_[c] = 0;
            }
        }
    }

    Patches patches_;
    LeafGroup group_;
    InsideRule rule_;
    Content content_;
    const std::function<bool(const glm::dvec3&)>& inside_;
    const std::stop_token& stop_;
    std::vector<Cell> cells_;
    std::vector<PlaneCells::Side> sides_;
    DisjointSets pieces_{0};
    std::vector<char> kept_;  ///< By the cell that stands for a piece.
};

}  // namespace

void check_surface(const Mesh& mesh, const std::stop_token& stop) {
    const MeshFacts f = facts(mesh);
    if (!f.manifold) {
        throw Undecided("the surface is not closed");
    }
    if (!(f.volume > 0)) {
        throw Undecided("the surface encloses no volume");
    }
    if (count_self_intersections(mesh, kCrossing * f.box.diagonal(), Overlaps::Counted, stop) != 0) {
        throw Undecided("the surface crosses itself");
    }
}

Mesh surface_of_patches(const Mesh& patches, const std::function<bool(const glm::dvec3&)>& inside,
                        const std::stop_token& stop) {
    return PatchSurface(patches, inside, stop).make();
}

}  // namespace csg::reference
