#include "npr/sorted/sorted_layers.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "npr/sorted/triangle_raster.h"

namespace npr {
namespace {

struct Hit {
    std::size_t pixel;
    double distance;
    std::uint32_t triangle;
    bool back;
};

void draw_triangle(const ColoredMesh& mesh, std::uint32_t triangle, const base::View& view, std::vector<Hit>& hits) {
    std::array<glm::dvec3, 3> eye;
    std::array<RasterCorner, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3& p = mesh.points[mesh.triangles[triangle][static_cast<int>(i)]];
        eye[i] = glm::dvec3(view.eye_from_world() * glm::dvec4(p, 1.0));
        at[i] = raster_corner(view, eye[i]);
    }
    const glm::dvec3 normal = glm::cross(eye[1] - eye[0], eye[2] - eye[0]);
    const bool back = view.orthographic() ? normal.z <= 0 : glm::dot(normal, eye[0]) >= 0;
    rasterize(view, eye, at, [&](int x, int y, double distance) {
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(view.size().x) + static_cast<std::size_t>(x);
        hits.push_back({pixel, distance, triangle, back});
    });
}

}  // namespace

void draw_layers(const ColoredMesh& mesh, const base::View& view,
                 const std::shared_ptr<const layers::SurfaceTable>& table, SortedLayers& to) {
    std::vector<Hit> hits;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        if (mesh.colors[i].a > 0) {
            draw_triangle(mesh, i, view, hits);
        }
    }
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
        return std::tie(a.pixel, a.distance, a.triangle) < std::tie(b.pixel, b.distance, b.triangle);
    });
    to.stack = {};
    to.stack.resize(view.size());
    to.stack.reserve(1);
    to.stack.table = table;
    to.stack.complete = true;
    std::size_t layer = 0, most = 1;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Hit& hit = hits[i];
        layer = i > 0 && hits[i - 1].pixel == hit.pixel ? layer + 1 : 0;
        most = std::max(most, layer + 1);
        to.stack.reserve(most);
        to.triangles.resize(std::max(to.triangles.size(), most));
        to.triangles[layer].resize(to.stack.planes[layer].depth.size());
        const ColoredMesh::Face& face = mesh.faces[hit.triangle];
        to.stack.planes[layer].depth[hit.pixel] = static_cast<float>(view.depth(hit.distance));
        to.stack.planes[layer].surface[hit.pixel] = layers::encode({1, face.leaf, face.plane, face.reversed, hit.back});
        to.triangles[layer][hit.pixel] = hit.triangle;
    }
    to.stack.layers = static_cast<int>(most);
    to.stack.count();
}

}  // namespace npr
