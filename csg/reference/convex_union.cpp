#include "csg/reference/convex_union.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

#include "base/stop.h"
#include "csg/reference/box_pairs.h"
#include "csg/reference/face_planes.h"
#include "csg/reference/manifold.h"
#include "csg/reference/mesh_boolean.h"
#include "csg/reference/patch_surface.h"
#include "csg/reference/plane_cells.h"

namespace csg::reference {
namespace {

/// A polyhedron by its planes.
struct Body {
    Box box;
    std::vector<solid::PlaneRef> faces;    ///< Of the triangles.
    std::vector<solid::PlaneRef> planes;   ///< Each once.
    std::vector<std::uint32_t> neighbors;  ///< Whose boxes meet this one's.
    bool swallowed = false;                ///< Another holds all of it.
};

class ConvexUnion {
  public:
    ConvexUnion(std::span<const Mesh> meshes, const std::stop_token& stop)
        : meshes_(meshes),
          stop_(stop),
          bodies_(meshes.size()),
          tolerance_(solid::coincidence_tolerance(largest_coordinate(meshes))) {
        planes_ = solid::PlaneTable(tolerance_);
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            Body& body = bodies_[i];
            for (const glm::dvec3& p : meshes[i].points) {
                body.box = enclose(body.box, p);
            }
            box_ = enclose(box_, body.box);
            boxes.push_back(body.box);
            body.faces = face_planes(meshes[i].points, meshes[i].triangles, planes_);
            body.planes = body.faces;
            std::sort(body.planes.begin(), body.planes.end(), less);
            body.planes.erase(std::unique(body.planes.begin(), body.planes.end(), equal), body.planes.end());
        }
        BoxTree(boxes).pairs([&](std::uint32_t a, std::uint32_t b) {
            bodies_[a].neighbors.push_back(b);
            bodies_[b].neighbors.push_back(a);
        });
    }

    /// Throws Undecided.
    Mesh make() {
        for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
            base::end_if_asked(stop_);
            bodies_[i].swallowed = swallowed(i);
        }
        std::vector<solid::PlacedLeaf> leaves(bodies_.size());
        LeafGroup group{{}, planes_.planes(), box_};
        for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
            base::end_if_asked(stop_);
            leaves[i] = visible_leaf(i);
            if (!leaves[i].triangles.empty()) {
                group.leaves.push_back(&leaves[i]);
                body_of_.push_back(i);
            }
        }
        const InsideRule rule(group);
        Content content = collect_segments(group, rule, stop_);
        split_segments(content, stop_);
        Mesh mesh;
        std::vector<glm::dvec3> normals;
        for (const PlaneContent& plane : content.planes) {
            base::end_if_asked(stop_);
            if (plane.segments.empty()) {
                continue;
            }
            const glm::dvec3 normal = plane.plane.normal;
            for (const PlaneCells::Cell& cell : make_cells(content, plane, rule).cells) {
                const std::optional<bool> above = solid_above(cell, plane.index, content.points);
                if (!above) {
                    continue;
                }
                for (glm::uvec3 t : cell.triangles) {
                    if (*above) {
                        std::swap(t.y, t.z);
                    }
                    mesh.triangles.push_back(t);
                    normals.push_back(*above ? -normal : normal);
                }
            }
        }
        mesh.points = content.points.points();
        mesh.sources.assign(mesh.triangles.size(), 0);
        separate_sheets(mesh, std::move(normals));
        check_surface(mesh, stop_);
        return mesh;
    }

  private:
    static bool less(const solid::PlaneRef& a, const solid::PlaneRef& b) {
        return a.index != b.index ? a.index < b.index : a.flipped < b.flipped;
    }
    static bool equal(const solid::PlaneRef& a, const solid::PlaneRef& b) {
        return a.index == b.index && a.flipped == b.flipped;
    }

    /// Is the point on the inner side of all planes, moved outwards by `margin`?
    [[nodiscard]] bool inside(const Body& body, const glm::dvec3& p, double margin) const {
        return std::all_of(body.planes.begin(), body.planes.end(), [&](const solid::PlaneRef& ref) {
            const solid::Plane& plane = planes_.planes()[ref.index];
            const double off = glm::dot(plane.normal, p) - plane.offset;
            return (ref.flipped ? -off : off) < margin;
        });
    }

    [[nodiscard]] static bool holds(const Box& outer, const Box& inner, double margin) {
        return glm::all(glm::lessThanEqual(outer.lo - margin, inner.lo)) &&
               glm::all(glm::lessThanEqual(inner.hi, outer.hi + margin));
    }

    [[nodiscard]] bool swallowed(std::uint32_t index) const {
        const Body& body = bodies_[index];
        return std::any_of(body.neighbors.begin(), body.neighbors.end(), [&](std::uint32_t other) {
            return !bodies_[other].swallowed && holds(bodies_[other].box, body.box, tolerance_) &&
                   std::all_of(meshes_[index].points.begin(), meshes_[index].points.end(),
                               [&](const glm::dvec3& p) { return inside(bodies_[other], p, tolerance_); });
        });
    }

    /// Without the faces, each as a whole, that lie inside another polyhedron.
    solid::PlacedLeaf visible_leaf(std::uint32_t index) {
        const Body& body = bodies_[index];
        solid::PlacedLeaf leaf;
        leaf.solid = convex_;
        if (body.swallowed) {
            return leaf;
        }
        const Mesh& mesh = meshes_[index];
        std::vector<std::vector<std::uint32_t>> corners(body.planes.size());
        std::vector<std::size_t> face_of;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto at = std::lower_bound(body.planes.begin(), body.planes.end(), body.faces[t], less);
            face_of.push_back(static_cast<std::size_t>(at - body.planes.begin()));
            for (int k = 0; k < 3; ++k) {
                corners[face_of[t]].push_back(mesh.triangles[t][k]);
            }
        }
        std::vector<char> hidden;
        for (auto& face : corners) {
            std::sort(face.begin(), face.end());
            face.erase(std::unique(face.begin(), face.end()), face.end());
            hidden.push_back(is_hidden(index, face));
        }
        std::vector<std::uint32_t> number(mesh.points.size(), ~std::uint32_t{0});
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (hidden[face_of[t]] != 0) {
                continue;
            }
            glm::uvec3 own;
            for (int k = 0; k < 3; ++k) {
                std::uint32_t& n = number[mesh.triangles[t][k]];
                if (n == ~std::uint32_t{0}) {
                    n = static_cast<std::uint32_t>(leaf.points.size());
                    leaf.points.push_back(mesh.points[mesh.triangles[t][k]]);
                    leaf.box = enclose(leaf.box, leaf.points.back());
                }
                own[k] = n;
            }
            leaf.triangles.push_back(own);
            leaf.planes.push_back(body.faces[t]);
        }
        return leaf;
    }

    [[nodiscard]] bool is_hidden(std::uint32_t index, const std::vector<std::uint32_t>& corners) const {
        const double margin = 16 * tolerance_;  // wide against what makes points one
        const std::vector<glm::dvec3>& points = meshes_[index].points;
        return std::any_of(bodies_[index].neighbors.begin(), bodies_[index].neighbors.end(), [&](std::uint32_t j) {
            return !bodies_[j].swallowed && std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
                return inside(bodies_[j], points[corner], -margin);
            });
        });
    }

    /// Of a cell on the surface: is the solid on the side that the plane's normal points to?
    std::optional<bool> solid_above(const PlaneCells::Cell& cell, std::uint32_t plane, const PointTable& points) {
        bool above = false, below = false;
        for (const Cover& cover : cell.covers) {
            const auto& planes = bodies_[body_of_[cover.leaf]].planes;
            const bool flipped = std::binary_search(planes.begin(), planes.end(), solid::PlaneRef{plane, true}, less);
            (flipped ? above : below) = true;
        }
        if (above == below) {
            return {};
        }
        const glm::dvec3 at = inside_of(cell, points);
        const Body& body = bodies_[body_of_[cell.covers[0].leaf]];
        const auto covers = [&](std::uint32_t j) {
            return !bodies_[j].swallowed && std::none_of(cell.covers.begin(), cell.covers.end(), [&](const Cover& c) {
                return body_of_[c.leaf] == j;
            }) && inside(bodies_[j], at, 0);
        };
        // Whatever covered the last cell is likely to cover this one.
        if (last_ < bodies_.size() && covers(last_)) {
            return {};
        }
        for (const std::uint32_t j : body.neighbors) {
            if (covers(j)) {
                last_ = j;
                return {};
            }
        }
        return above;
    }

    /// The middle of the cell's largest triangle.
    static glm::dvec3 inside_of(const PlaneCells::Cell& cell, const PointTable& points) {
        glm::dvec3 at(0.0);
        double largest = -1;
        for (const glm::uvec3& t : cell.triangles) {
            const glm::dvec3 &p = points[t.x], &q = points[t.y], &r = points[t.z];
            const glm::dvec3 across = glm::cross(q - p, r - p);
            if (const double area2 = glm::dot(across, across); area2 > largest) {
                largest = area2;
                at = (p + q + r) / 3.0;
            }
        }
        return at;
    }

    static std::shared_ptr<const solid::Solid> convex_solid() {
        auto solid = std::make_shared<solid::Solid>();
        solid->closed = solid->convex = true;
        return solid;
    }

    std::span<const Mesh> meshes_;
    const std::stop_token& stop_;
    std::vector<Body> bodies_;
    double tolerance_;
    solid::PlaneTable planes_;
    Box box_;
    std::vector<std::uint32_t> body_of_;  ///< By leaf of the group.
    std::shared_ptr<const solid::Solid> convex_ = convex_solid();
    std::uint32_t last_ = ~std::uint32_t{0};
};

}  // namespace

Mesh union_of_convex(std::span<const Mesh> meshes, const std::stop_token& stop) {
    if (meshes.empty()) {
        return {};
    }
    if (meshes.size() == 1) {
        return meshes[0];
    }
    try {
        return ConvexUnion(meshes, stop).make();
    } catch (const Undecided&) {
    } catch (const std::logic_error&) {  // CGAL's, of a triangulation that contradicts itself
    }
    return combine(ExpressionKind::Union, meshes, stop).mesh;
}

}  // namespace csg::reference
