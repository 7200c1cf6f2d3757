#include "ui/pipeline/comparison/mesh_layers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {

namespace {

/// Is the sample s on the left of a → b, in homogeneous pixels? Computed from the same end for both triangles at an
/// edge, so that it is on different sides for the two, whatever the rounding. A sample on the edge is moved a little to
/// the right, and less upwards, the same for all.
bool left(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& s) {
    const auto order = [](const glm::dvec3& v) { return std::array{v.x, v.y, v.z}; };
    if (order(b) < order(a)) {
        return !left(b, a, s);
    }
    const glm::dvec3 line = glm::cross(a, b);
    const double side = glm::dot(s, line);
    return side != 0 ? side > 0 : line.x != 0 ? line.x > 0 : line.y > 0;
}

}  // namespace

MeshLayers mesh_layers(const csg::reference::Mesh& mesh, const base::View& view) {
    MeshLayers layers{view.size(), {}};
    const glm::ivec2 size = view.size();
    layers.of.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    const double scale = size.y / (2 * view.half_height());
    const glm::dvec2 half = 0.5 * glm::dvec2(size);
    // (X, Y, W): X / W and Y / W are pixels.
    std::vector<glm::dvec3> eye, at;
    for (const glm::dvec3& p : mesh.points) {
        const glm::dvec3 e(view.eye_from_world() * glm::dvec4(p, 1));
        const double w = view.orthographic() ? 1.0 : -e.z;
        eye.push_back(e);
        at.emplace_back(e.x * scale + (half.x - view.jitter().x) * w, e.y * scale + (half.y - view.jitter().y) * w, w);
    }
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const glm::dvec3 &a = at[t.x], &b = at[t.y], &c = at[t.z];
        glm::dvec2 lo(0), hi(size);
        if (a.z > 0 && b.z > 0 && c.z > 0) {
            const glm::dvec2 p(a / a.z), q(b / b.z), r(c / c.z);
            lo = glm::max(lo, glm::floor(glm::min(p, glm::min(q, r)) - 1.0));
            hi = glm::min(hi, glm::ceil(glm::max(p, glm::max(q, r)) + 1.0));
        } else if (a.z <= 0 && b.z <= 0 && c.z <= 0) {
            continue;
        }
        const glm::dvec3 n = glm::cross(eye[t.y] - eye[t.x], eye[t.z] - eye[t.x]);
        const double offset = glm::dot(n, eye[t.x]);
        for (int y = static_cast<int>(lo.y); y < static_cast<int>(hi.y); ++y) {
            for (int x = static_cast<int>(lo.x); x < static_cast<int>(hi.x); ++x) {
                const glm::dvec3 s(x + 0.5, y + 0.5, 1.0);
                const bool u = left(a, b, s), v = left(b, c, s), w = left(c, a, s);
                if (u != v || v != w) {
                    continue;
                }
                const double ex = (s.x - half.x + view.jitter().x) / scale;
                const double ey = (s.y - half.y + view.jitter().y) / scale;
                const double distance =
                    view.orthographic() ? (n.x * ex + n.y * ey - offset) / n.z : offset / (n.x * ex + n.y * ey - n.z);
                if (distance > view.near_distance() && std::isfinite(distance)) {
                    layers
                        .of[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                            static_cast<std::size_t>(x)]
                        .push_back({distance, i});
                }
            }
        }
    }
    for (auto& surfaces : layers.of) {
        std::sort(surfaces.begin(), surfaces.end(), [](const MeshSurface& a, const MeshSurface& b) {
            return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
        });
    }
    return layers;
}

}  // namespace ui
