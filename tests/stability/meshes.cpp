// Leaves that are meshes of all kinds.
#include <algorithm>
#include <cmath>

#include "tests/stability/family.h"

namespace stability {

namespace {

using Id = Maker::Id;
using Faces = std::vector<std::vector<std::uint32_t>>;
const glm::dvec3 kEye(13, -17, 15);

/// The faces of a box whose corners are numbered by their bits x, y, z; counter-clockwise or not, `first` added.
Faces box_faces(std::uint32_t first, bool inverted = false) {
    Faces faces{{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    for (auto& face : faces) {
        for (std::uint32_t& i : face) {
            i += first;
        }
        if (inverted) {
            std::reverse(face.begin(), face.end());
        }
    }
    return faces;
}

std::vector<glm::dvec3> box_points(const glm::dvec3& lo, const glm::dvec3& size) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 8; ++i) {
        points.push_back(lo + size * glm::dvec3(i & 1, i >> 1 & 1, i >> 2 & 1));
    }
    return points;
}

/// A comb: n teeth of one mesh, which a ray may cross one after the other.
Id comb(Maker& m, int n) {
    std::vector<glm::dvec2> outline;
    for (int i = 0; i < n; ++i) {
        const double x = -4 + 8.0 * i / n, w = 4.0 / n;
        outline.insert(outline.end(), {{x, 1}, {x, 6}, {x + w, 6}, {x + w, 1}});
    }
    outline.insert(outline.end(), {{4, 0}, {-4, 0}});
    const auto count = static_cast<std::uint32_t>(outline.size());
    std::vector<glm::dvec3> points;
    for (const double z : {0.0, 3.0}) {
        for (const glm::dvec2& p : outline) {
            points.emplace_back(p.x, z, p.y);
        }
    }
    Faces faces(2);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t j = (i + 1) % count;
        faces[0].push_back(i);
        faces[1].push_back(2 * count - 1 - i);
        faces.push_back({i, count + i, count + j, j});
    }
    return m.mesh(std::move(points), std::move(faces));
}

}  // namespace

void add_meshes(std::vector<Family>& all) {
    all.push_back({"one mesh, many layers",
                   "A comb of n teeth, drilled, seen along its length.",
                   "teeth",
                   {1, 2, 5, 10, 25, 60},
                   [](double n) {
                       Maker m;
                       const Id drilled = m.subtract(
                           {comb(m, static_cast<int>(n)), m.turn(90, {0, 1, 0}, m.cylinder({-3, 1.5, -5}, 10, 1))});
                       return m.seen(drilled, {30, -6, 9}, {0, 1, 3}, 16);
                   }});
    all.push_back({"self-intersecting meshes",
                   "n boxes that overlap within one mesh: solid throughout.",
                   "boxes",
                   {1, 2, 3, 5, 8},
                   [](double n) {
                       Maker m;
                       std::vector<glm::dvec3> points;
                       Faces faces;
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           const auto first = static_cast<std::uint32_t>(points.size());
                           for (const glm::dvec3& p : box_points(glm::dvec3(-4 + 0.7 * i), {3, 4, 5})) {
                               points.push_back(p);
                           }
                           for (auto& face : box_faces(first)) {
                               faces.push_back(std::move(face));
                           }
                       }
                       const Id mesh = m.mesh(std::move(points), std::move(faces));
                       return m.seen(m.subtract({mesh, m.sphere({0, 0, 0}, 2)}), {15, -20, 11}, {0, 0, 0});
                   }});
    all.push_back({"open meshes",
                   "A box that lacks n of its faces, as a cutter.",
                   "missing faces",
                   {0, 1, 2, 3, 4, 5},
                   [](double missing) {
                       Maker m;
                       Faces faces = box_faces(0);
                       faces.resize(faces.size() - static_cast<std::size_t>(missing));
                       const Id open = m.mesh(box_points({-2, -2, -2}, {4, 4, 7}), faces);
                       return m.seen(m.subtract({m.box({-4, -4, -4}, {8, 8, 8}), open}), {13, -17, 25}, {0, 0, 0});
                   }});
    all.push_back(
        {"inverted meshes", "Boxes turned inside out, subtracted and added.", "boxes", {1, 2, 3, 4, 6}, [](double n) {
             Maker m;
             std::vector<Id> body{m.mesh(box_points({-4, -4, -4}, {8, 8, 8}), box_faces(0, true))};
             for (int i = 0; i < static_cast<int>(n); ++i) {
                 body.push_back(m.mesh(box_points({-4 + 8 * i / n, -4, 0}, {4 / n, 8, 4}), box_faces(0, true)));
             }
             return m.seen(m.subtract(body), kEye, {0, 0, 0});
         }});
    all.push_back({"duplicate faces",
                   "A box with every face n times, which is the same box.",
                   "times",
                   {1, 2, 3, 4, 5},
                   [](double n) {
                       Maker m;
                       Faces faces;
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           for (auto& face : box_faces(0)) {
                               faces.push_back(std::move(face));
                           }
                       }
                       const Id twice = m.mesh(box_points({-2, -2, 0}, {4, 4, 6}), faces);
                       return m.seen(m.subtract({m.box({-4, -4, -4}, {8, 8, 8}), twice}), {13, -17, 25}, {0, 0, 0});
                   }});
    all.push_back({"fine spheres",
                   "A ball less a ball, of this many sides.",
                   "sides",
                   {6, 12, 24, 48, 96, 192},
                   [](double sides) {
                       Maker m;
                       const Id cut = m.subtract({m.sphere({0, 0, 0}, 4, sides), m.sphere({1.5, -1.5, 2}, 2.5, sides)});
                       return m.seen(cut, kEye, {0, 0, 0});
                   }});
    all.push_back({"convexity that lies",
                   "A ring of n posts in one mesh, cut across.",
                   "posts",
                   {2, 5, 10, 20, 40},
                   [](double n) {
                       Maker m;
                       std::vector<glm::dvec3> points;
                       Faces faces;
                       for (int i = 0; i < static_cast<int>(n); ++i) {
                           const double a = 6.28318 * i / n;
                           const auto first = static_cast<std::uint32_t>(points.size());
                           for (const glm::dvec3& p :
                                box_points({3.5 * std::cos(a) - 0.2, 3.5 * std::sin(a) - 0.2, 0}, {0.4, 0.4, 4})) {
                               points.push_back(p);
                           }
                           for (auto& face : box_faces(first)) {
                               faces.push_back(std::move(face));
                           }
                       }
                       const Id posts = m.mesh(std::move(points), std::move(faces));
                       return m.seen(m.subtract({posts, m.box({-5, -5, 1}, {10, 5, 1})}), {20, -12, 6}, {0, 0, 2});
                   }});
}

}  // namespace stability
