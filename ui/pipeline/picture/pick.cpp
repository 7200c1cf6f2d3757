#include "ui/pipeline/picture/pick.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

void find_materials(const csg::Scene& scene, std::vector<PickedSurface>& surfaces) {
    std::vector<char> inside(scene.parts.size(), 0), seen(scene.parts.size(), 0);
    for (const PickedSurface& s : surfaces) {
        if (seen[s.part] == 0) {
            seen[s.part] = 1;
            inside[s.part] = s.surface.leaving ? 1 : 0;  // The eye may be in it.
        }
    }
    const auto holding = [&] {
        std::vector<csg::PartId> parts;
        for (csg::PartId part = 0; part < inside.size(); ++part) {
            if (inside[part] != 0 && scene.parts[part].kind != csg::PartKind::Highlight) {
                parts.push_back(part);
            }
        }
        return parts;
    };
    // Surfaces of one depth are passed together.
    for (std::size_t begin = 0, end = 0; begin < surfaces.size(); begin = end) {
        const std::vector<csg::PartId> before = holding();
        for (; end < surfaces.size() && surfaces[end].surface.depth == surfaces[begin].surface.depth; ++end) {
            inside[surfaces[end].part] = surfaces[end].surface.leaving ? 0 : 1;
        }
        const std::vector<csg::PartId> after = holding();
        for (std::size_t i = begin; i < end; ++i) {
            surfaces[i].in_front = before;
            surfaces[i].behind = after;
        }
    }
}

}  // namespace

base::Camera pixel_camera(const base::Camera& camera, glm::ivec2 size, glm::dvec2 cursor) {
    const base::View view(camera, size, camera.target, camera.target);
    const base::View::Ray ray = view.ray(cursor.x - 0.5, size.y - cursor.y - 0.5);
    const glm::dvec3 point = ray.origin + camera.distance * ray.direction;
    base::Camera narrow = camera;
    if (camera.projection == base::Projection::Perspective) {
        narrow = base::camera_between(camera.eye(), point);
        narrow.fov = camera.fov;
    }
    narrow.target = point;
    narrow.fov = std::max(narrow.fov / std::max(size.y, 1), 1e-3);
    return narrow;
}

std::vector<PickedSurface> picked(const Model& model, const base::View& view, const layers::HostStack& stack) {
    const base::View::Ray ray = view.ray(0, 0);
    std::vector<PickedSurface> result;
    for (int layer = 0; layer < stack.layers && stack.at(layer, 0, 0).depth > 0; ++layer) {
        const layers::Surface surface = stack.at(layer, 0, 0);
        const csg::solid::Plane& plane = model.geometry.planes.planes()[surface.plane];
        const csg::LeafInstance& leaf = model.scene.leaves[surface.leaf];
        PickedSurface s;
        s.layer = layer;
        s.surface = surface;
        s.distance = view.distance(surface.depth);
        // The plane tells more exactly than the depth, unless it is seen from the side.
        const double slope = glm::dot(plane.normal, ray.direction);
        const double exact = (plane.offset - glm::dot(plane.normal, ray.origin)) / slope;
        constexpr double kRounding = 1e-5;  // Of depths in single precision, with room.
        if (std::abs(exact - s.distance) <= kRounding * std::abs(s.distance)) {
            s.distance = exact;
        }
        s.point = ray.origin + s.distance * ray.direction;
        s.normal = (slope > 0) == surface.leaving ? plane.normal : -plane.normal;
        s.part = leaf.part;
        s.occurrence = leaf.occurrence;
        result.push_back(std::move(s));
    }
    find_materials(model.scene, result);
    return result;
}

}  // namespace ui
