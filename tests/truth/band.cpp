#include "tests/truth/band.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>
#include <utility>

namespace truth {
namespace {

constexpr double kSnap = 1.0 / 256;  // pixels
constexpr double kFloat = 0x1p-24;   // half a unit in the last place

glm::dvec3 abs_cross(const glm::dvec3& a, const glm::dvec3& b) {
    return {a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x};
}

/// The edges of a leaf where something ends or bends: all but those between two triangles of one plane that lie on
/// either side of it.
std::vector<std::pair<std::uint32_t, std::uint32_t>> bends(const csg::solid::PlacedLeaf& leaf) {
    struct Use {
        int forward = 0, backward = 0;
        std::uint32_t plane = 0;
        bool flipped = false, bend = false;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Use> uses;
    for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = leaf.triangles[t][i], b = leaf.triangles[t][(i + 1) % 3];
            Use& use = uses[std::minmax(a, b)];
            const csg::solid::PlaneRef plane = leaf.planes[t];
            if (use.forward + use.backward == 0) {
                use.plane = plane.index;
                use.flipped = plane.flipped;
            }
            use.bend |= use.plane != plane.index || use.flipped != plane.flipped;
            ++(a < b ? use.forward : use.backward);
        }
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
    for (const auto& [edge, use] : uses) {
        if (use.bend || use.forward != 1 || use.backward != 1) {
            result.push_back(edge);
        }
    }
    return result;
}

}  // namespace

Band::Band(const csg::solid::Geometry& geometry, const base::View& view)
    : geometry_(geometry), view_(view), local_center_(geometry.box.empty() ? glm::dvec3(0.0) : geometry.box.center()) {
    // Rows x, y, w of the clip matrix, x and y in pixels.
    const double scale = view.size().y / (2 * view.half_height());
    glm::dmat4 project(0.0);
    project[0][0] = project[1][1] = scale;
    project[view.orthographic() ? 3 : 2][2] = view.orthographic() ? 1 : -1;
    to_pixels_ = project * glm::translate(view.eye_from_world(), local_center_);
    for (const csg::solid::PlacedLeaf& leaf : geometry.leaves) {
        std::vector<Vertex> vertices;
        for (const glm::dvec3& p : leaf.points) {
            vertices.push_back(this->project(p));
        }
        for (const auto& [a, b] : bends(leaf)) {
            add_edge(vertices[a], vertices[b]);
        }
        for (const glm::uvec3& t : leaf.triangles) {
            add_near_cut(vertices[t.x], vertices[t.y], vertices[t.z]);
        }
    }
    for (const csg::solid::Plane& plane : geometry.planes.planes()) {
        planes_.push_back(view.plane_depth(plane.normal, plane.offset));
    }
}

Band::Vertex Band::project(const glm::dvec3& world) const {
    const glm::dvec4 local(world - local_center_, 1.0);
    Vertex v{glm::dvec3(0.0), glm::dvec3(0.0)};
    v.at = glm::dvec3(to_pixels_ * local);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            v.error[row] += 7 * kFloat * std::abs(to_pixels_[column][row] * local[column]);
        }
    }
    return v;
}

void Band::add_edge(const Vertex& p, const Vertex& q) {
    const double nearest = view_.orthographic() ? 0.5 : 0.5 * view_.near_distance();
    if (p.at.z < nearest && q.at.z < nearest) {
        return;
    }
    const auto clipped = [&](const glm::dvec3& a, const glm::dvec3& b) {
        const glm::dvec3 c = a.z >= nearest ? a : glm::mix(a, b, (nearest - a.z) / (b.z - a.z));
        return glm::dvec2(c) / c.z;
    };
    const glm::dvec2 from = clipped(p.at, q.at), to = clipped(q.at, p.at);
    const glm::dvec3 line = glm::cross(p.at, q.at);
    const double length = std::hypot(line.x, line.y);
    const glm::dvec3 error = abs_cross(p.error, glm::abs(q.at)) + abs_cross(glm::abs(p.at), q.error);
    Edge edge;
    edge.lo = glm::min(from, to) - 4 * kSnap;
    edge.hi = glm::max(from, to) + 4 * kSnap;
    if (length > 0) {
        edge.line = line / length;
        edge.error = error / length;
    } else {
        edge.line = glm::dvec3(0.0);  // seen end-on: all of its box
        edge.error = glm::dvec3(0.0);
    }
    edges_.push_back(edge);
}

void Band::add_near_cut(const Vertex& a, const Vertex& b, const Vertex& c) {
    const double nearest = view_.near_distance();
    const auto hidden = [&](const Vertex& v) { return v.at.z - v.error.z <= nearest; };
    if (view_.orthographic() || (!hidden(a) && !hidden(b) && !hidden(c))) {
        return;
    }
    // On the triangle's plane normal · (x W, y W, W) = offset; at W = near that is a line. Its unit is a pixel there.
    const glm::dvec3 normal = glm::cross(b.at - a.at, c.at - a.at);
    const double offset = glm::dot(normal, a.at);
    const double unit = nearest * std::max(std::hypot(normal.x, normal.y), 1e-9 * glm::length(normal));
    if (!(unit > 0)) {
        return;
    }
    const double infinity = std::numeric_limits<double>::infinity();
    const glm::dvec3 error = glm::max(a.error, glm::max(b.error, c.error));
    edges_.push_back({(nearest * normal - glm::dvec3(0, 0, offset)) / unit,
                      glm::dvec3(0, 0, glm::dot(glm::abs(normal), error) / unit), glm::dvec2(-infinity),
                      glm::dvec2(infinity)});
}

glm::dvec2 Band::sample(int x, int y) const {
    return glm::dvec2(x, y) + 0.5 - 0.5 * glm::dvec2(view_.size());
}

bool Band::near_edge(int x, int y) const {
    const glm::dvec2 s = sample(x, y);
    return std::any_of(edges_.begin(), edges_.end(), [&](const Edge& e) {
        return s.x >= e.lo.x && s.x <= e.hi.x && s.y >= e.lo.y && s.y <= e.hi.y &&
               std::abs(glm::dot(e.line, glm::dvec3(s, 1.0))) <=
                   kSnap + glm::dot(e.error, glm::dvec3(glm::abs(s), 1.0));
    });
}

double Band::edge_distance(int x, int y) const {
    const glm::dvec2 s = sample(x, y);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Edge& e : edges_) {
        if (s.x >= e.lo.x && s.x <= e.hi.x && s.y >= e.lo.y && s.y <= e.hi.y) {
            nearest = std::min(nearest, std::abs(glm::dot(e.line, glm::dvec3(s, 1.0))));
        }
    }
    return nearest;
}

double Band::depth_error(std::uint32_t plane, int x, int y, double t) const {
    const base::View::PlaneDepth& p = planes_[plane];
    if (p.edge_on) {
        return std::numeric_limits<double>::infinity();
    }
    const glm::dvec2 s = sample(x, y);
    const double rounding = 4 * kFloat *
                            (std::abs(static_cast<double>(p.a) * s.x) + std::abs(static_cast<double>(p.b) * s.y) +
                             std::abs(static_cast<double>(p.c)));
    const glm::dvec3 direction = view_.ray(x, y).direction;
    const double across = std::abs(glm::dot(geometry_.planes.planes()[plane].normal, direction));
    const double per_distance =
        view_.orthographic() ? 1 / (view_.far_distance() - view_.near_distance()) : view_.near_distance() / (t * t);
    return rounding + geometry_.planes.tolerance() / across * per_distance;
}

}  // namespace truth
