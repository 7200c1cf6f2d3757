#include "csg/reference/convolution_sum.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "csg/reference/box_pairs.h"
#include "csg/reference/components.h"
#include "csg/reference/convex_cut.h"
#include "csg/reference/convolution.h"
#include "csg/reference/face_planes.h"
#include "csg/reference/patch_surface.h"
#include "csg/reference/segments.h"
#include "csg/reference/self_intersection.h"
#include "csg/solid/winding_number.h"

namespace csg::reference {
namespace {

/// As for results (boolean.cpp), of the diagonal.
constexpr double kCrossing = 1e-8;

void append(Mesh& all, const Mesh& more) {
    const auto first = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), more.points.begin(), more.points.end());
    for (const glm::uvec3& t : more.triangles) {
        all.triangles.push_back(t + first);
    }
    all.sources.resize(all.triangles.size(), 0);
}

/// Is a point in the sum?
class Membership {
  public:
    Membership(std::span<const Mesh> meshes, const Convex& b) : meshes_(meshes), middle_(b.middle()) {
        for (const Mesh& mesh : meshes) {
            append(surface_, mesh);
        }
        boxes_ = triangle_boxes(surface_.points, surface_.triangles);
        for (const glm::dvec3& p : b.points()) {
            box_ = enclose(box_, p);
        }
        solid::PlaneTable table(solid::coincidence_tolerance(largest_coordinate(b.points())));
        std::vector<solid::PlaneRef> refs = face_planes(b.points(), b.triangles(), table);
        std::sort(refs.begin(), refs.end(), [](const solid::PlaneRef& p, const solid::PlaneRef& q) {
            return p.index != q.index ? p.index < q.index : p.flipped < q.flipped;
        });
        for (std::size_t i = 0; i < refs.size(); ++i) {
            if (i > 0 && refs[i].index == refs[i - 1].index && refs[i].flipped == refs[i - 1].flipped) {
                continue;
            }
            const solid::Plane& plane = table.planes()[refs[i].index];
            const double sign = refs[i].flipped ? -1 : 1;
            planes_.push_back({plane.normal * sign, plane.offset * sign});
        }
    }

    [[nodiscard]] bool operator()(const BoxTree& tree, const glm::dvec3& point) const {
        std::vector<solid::Plane> planes;  // of point - b
        planes.reserve(planes_.size());
        for (const solid::Plane& plane : planes_) {
            planes.push_back({-plane.normal, plane.offset - glm::dot(plane.normal, point)});
        }
        bool met = false;
        tree.meeting({point - box_.hi, point - box_.lo}, [&](std::uint32_t i) {
            const glm::uvec3& t = surface_.triangles[i];
            met = met || cuts({surface_.points[t.x], surface_.points[t.y], surface_.points[t.z]}, planes, 0);
        });
        return met || std::any_of(meshes_.begin(), meshes_.end(), [&](const Mesh& mesh) {
                   return solid::winding_number(mesh.points, mesh.triangles, point - middle_) != 0;
               });
    }
    [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }

  private:
    std::span<const Mesh> meshes_;
    glm::dvec3 middle_;
    Mesh surface_;
    std::vector<Box> boxes_;  ///< Of its triangles.
    Box box_;
    std::vector<solid::Plane> planes_;
};

/// Is the outside of each component what the mesh does not wind around?
bool faces_outwards(const Mesh& mesh, const std::vector<Mesh>& components) {
    const double distance = 64 * solid::coincidence_tolerance(largest_coordinate(mesh.points));
    return std::all_of(components.begin(), components.end(), [&](const Mesh& component) {
        return solid::winding_number(mesh.points, mesh.triangles, before(component, distance)) == 0;
    });
}

}  // namespace

std::optional<Mesh> convolution_sum(std::span<const Mesh> meshes, const Convex& b, const std::stop_token& stop) {
    Mesh patches;
    for (const Mesh& mesh : meshes) {
        const std::vector<Mesh> components = components_of(mesh);
        if (count_self_intersections(mesh, kCrossing * facts(mesh).box.diagonal(), Overlaps::Counted, stop) != 0 ||
            !faces_outwards(mesh, components)) {
            return {};
        }
        for (const Mesh& component : components) {
            const std::optional<Mesh> own = convolution(component, b, stop);
            if (!own) {
                return {};
            }
            append(patches, *own);
        }
    }
    const Membership membership(meshes, b);
    const BoxTree tree(membership.boxes());
    try {
        return surface_of_patches(
            patches, [&](const glm::dvec3& point) { return membership(tree, point); }, stop);
    } catch (const Undecided&) {
    } catch (const std::logic_error&) {  // CGAL's, of a triangulation that contradicts itself
    }
    return {};
}

}  // namespace csg::reference
