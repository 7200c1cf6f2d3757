// The segment Voronoi diagram (boost::polygon, exact for integers) cut by the outline. Corners of the mesh are numbered
// by vertex of the diagram, and an edge is divided once for both of its cells, so neighboring faces share their
// points.
#include "csg/reference/voronoi_roof.h"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <unordered_map>

#include "base/stop.h"
#include "csg/reference/grid_outline.h"
#include "csg/reference/manifold.h"
#include "csg/reference/point_ids.h"
#include "csg/reference/roof_faces.h"
#include "csg/solid/solid.h"
#include "csg/solid/triangulate_region.h"

namespace csg::reference {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using Cell = Diagram::cell_type;
using Edge = Diagram::edge_type;
using Vertex = Diagram::vertex_type;
using Ids = std::vector<std::uint32_t>;

constexpr std::uint32_t kNone = ~std::uint32_t{0};
// In cells of the grid: a vertex of the diagram nearer to a corner is that corner. Coordinates are right to 2^-17.
constexpr double kAtCorner = 1.0 / 64;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// An edge of the outline, the region on its left.
struct Side {
    glm::dvec2 from, to;
    std::uint32_t from_id, to_id;

    /// Positive on the region's side; in cells of the grid.
    [[nodiscard]] double distance(const glm::dvec2& p) const {
        return cross(to - from, p - from) / glm::length(to - from);
    }
};

glm::dvec2 position(const Vertex& vertex) {
    return {vertex.x(), vertex.y()};
}

class Builder {
  public:
    Builder(const GridOutline& outline, const Fineness& fineness) : outline_(outline), fineness_(fineness) {}

    Mesh run() {
        add_floor();
        build_diagram();
        find_corners();
        for (const Cell& cell : diagram_.cells()) {
            if (cell.is_degenerate()) {  // A corner between four edges, say.
                continue;
            }
            if (cell.contains_segment()) {
                add_plane(cell);
            } else {
                add_cone(cell);
            }
        }
        return std::move(mesh_);
    }

  private:
    std::uint32_t point(const glm::dvec2& p, double z) {
        const auto [id, added] = known_.add({p, z});
        if (added) {
            mesh_.points.emplace_back(p, z);
        }
        return id;
    }

    /// Seen from below. Numbers the corners and lists the sides.
    void add_floor() {
        solid::Outline floor;
        Ids ids;
        for (const GridOutline::Loop& corners : outline_.loops()) {
            solid::Loop& loop = floor.loops.emplace_back();
            const std::size_t first = ids.size(), n = corners.size();
            for (const GridOutline::Point& p : corners) {
                loop.push_back(outline_.corner(p));
                ids.push_back(point(loop.back(), 0));
            }
            for (std::size_t i = 0; i < n; ++i) {
                sides_.push_back({corners[i], corners[(i + 1) % n], ids[first + i], ids[first + (i + 1) % n]});
            }
        }
        const solid::IndexedOutline indexed = solid::index_corners(floor);
        ids.clear();
        for (const glm::dvec2& p : indexed.points) {
            ids.push_back(point(p, 0));
        }
        for (const glm::uvec3& t : solid::triangulate_region(indexed)) {
            mesh_.triangles.emplace_back(ids[t.x], ids[t.z], ids[t.y]);
        }
    }

    void build_diagram() {
        using Coordinate = std::int32_t;
        boost::polygon::default_voronoi_builder builder;
        const auto whole = [](double value) { return static_cast<Coordinate>(value); };
        for (const Side& s : sides_) {
            builder.insert_segment(whole(s.from.x), whole(s.from.y), whole(s.to.x), whole(s.to.y));
        }
        builder.construct(&diagram_);
        ids_.assign(diagram_.vertices().size(), kNone);
    }

    [[nodiscard]] std::uint32_t& id_of(const Vertex& vertex) {
        return ids_[static_cast<std::size_t>(&vertex - diagram_.vertices().data())];
    }
    [[nodiscard]] const Side& side_of(const Cell& cell) const { return sides_[cell.source_index()]; }
    [[nodiscard]] static bool at_start(const Cell& cell) {
        return cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
    }
    /// Of the cell of a corner.
    [[nodiscard]] glm::dvec2 corner_of(const Cell& cell) const {
        return at_start(cell) ? side_of(cell).from : side_of(cell).to;
    }

    /// Numbers the vertices of the diagram that are corners of the outline.
    void find_corners() {
        for (const Edge& edge : diagram_.edges()) {
            const Vertex* vertex = edge.vertex0();
            if (vertex == nullptr) {
                continue;
            }
            const Side& side = side_of(*edge.cell());
            if (glm::distance(position(*vertex), side.from) < kAtCorner) {
                id_of(*vertex) = side.from_id;
            } else if (glm::distance(position(*vertex), side.to) < kAtCorner) {
                id_of(*vertex) = side.to_id;
            }
        }
    }

    /// The number of a vertex of `cell`, a point of the roof if it is no corner.
    std::uint32_t roof_point(const Vertex& vertex, const Cell& cell) {
        std::uint32_t& id = id_of(vertex);
        if (id == kNone) {
            const glm::dvec2 p = position(vertex);
            const double height =
                cell.contains_segment() ? std::abs(side_of(cell).distance(p)) : glm::distance(p, corner_of(cell));
            id = point(outline_.place(p), outline_.length(height));
        }
        return id;
    }

    /// The points that divide an edge seen from a corner's cell, which is edge.cell(), from its start to its end.
    Ids divide(const Edge& edge) {
        const glm::dvec2 corner = corner_of(*edge.cell());
        const glm::dvec2 from = position(*edge.vertex0()) - corner, to = position(*edge.vertex1()) - corner;
        const double angle = std::atan2(cross(from, to), glm::dot(from, to));
        const double radius = outline_.length(std::max(glm::length(from), glm::length(to)));
        const double step = 2 * std::numbers::pi / solid::circle_segments(radius, fineness_);
        const int pieces = static_cast<int>(std::ceil(std::abs(angle) / step - 1e-6));
        const Cell& other = *edge.twin()->cell();
        Ids points;
        for (int i = 1; i < pieces; ++i) {
            const double part = angle * i / pieces, c = std::cos(part), s = std::sin(part);
            const glm::dvec2 ray = glm::normalize(glm::dvec2(c * from.x - s * from.y, s * from.x + c * from.y));
            double r = 0;  // Along the ray, as far from the other site as from the corner.
            if (other.contains_segment()) {
                const Side& side = side_of(other);
                const glm::dvec2 along = glm::normalize(side.to - side.from), normal(-along.y, along.x);
                r = side.distance(corner) / (1 - glm::dot(ray, normal));
            } else {
                const glm::dvec2 way = corner_of(other) - corner;
                r = glm::dot(way, way) / (2 * glm::dot(ray, way));
            }
            points.push_back(point(outline_.place(corner + r * ray), outline_.length(r)));
        }
        return points;
    }

    /// Appends the start of an edge and what divides it, as both of its cells do.
    void append(const Edge& edge, Ids& loop) {
        if (edge.vertex0() == nullptr || edge.vertex1() == nullptr) {
            throw std::runtime_error("an outline is not closed");
        }
        loop.push_back(roof_point(*edge.vertex0(), *edge.cell()));
        if (edge.is_secondary()) {
            return;  // Between an edge of the outline and its end: straight, and so is the roof.
        }
        const bool first =
            !edge.cell()->contains_segment() && (edge.twin()->cell()->contains_segment() || &edge < edge.twin());
        const Edge& divided = first ? edge : *edge.twin();
        if (divided.cell()->contains_segment()) {
            return;  // Between two edges.
        }
        const auto [at, added] = divisions_.try_emplace(&divided);
        if (added) {
            at->second = divide(divided);
        }
        if (first) {
            loop.insert(loop.end(), at->second.begin(), at->second.end());
        } else {
            loop.insert(loop.end(), at->second.rbegin(), at->second.rend());
        }
    }

    /// From the end of the side over the region back to its start.
    void add_plane(const Cell& cell) {
        const Side& side = side_of(cell);
        const auto starts_at = [&](const Edge& edge, std::uint32_t id) {
            return edge.vertex0() != nullptr && id_of(*edge.vertex0()) == id;
        };
        const auto walk = [&](const Edge* edge, std::uint32_t id, auto&& visit) {
            const Edge* const start = edge;
            while (!starts_at(*edge, id)) {
                visit(*edge);
                edge = edge->next();
                if (edge == start) {
                    throw std::runtime_error("an edge of the outline has no cell");
                }
            }
            return edge;
        };
        const auto pass = [](const Edge&) {};
        const Edge* const first = walk(walk(cell.incident_edge(), side.from_id, pass), side.to_id, pass);
        Ids loop;
        walk(first, side.from_id, [&](const Edge& edge) { append(edge, loop); });
        loop.push_back(side.from_id);
        loop = reduced(loop);
        std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), side.to_id), loop.end());
        triangulate_over_eaves(mesh_.points, loop, mesh_.triangles);
    }

    /// The cell of a corner lies in the region where it is to the left of the sides that end there.
    [[nodiscard]] bool is_inside(const Cell& cell) const {
        const glm::dvec2 corner = corner_of(cell);
        double farthest = 0, height = 0;
        const Edge* edge = cell.incident_edge();
        do {
            if (edge->vertex0() == nullptr || edge->vertex1() == nullptr) {
                return false;
            }
            if (edge->is_secondary()) {
                for (const Vertex* vertex : {edge->vertex0(), edge->vertex1()}) {
                    const double way = glm::distance(position(*vertex), corner);
                    if (way > farthest) {
                        farthest = way;
                        height = side_of(*edge->twin()->cell()).distance(position(*vertex));
                    }
                }
            }
            edge = edge->next();
        } while (edge != cell.incident_edge());
        return height > 0;
    }

    void add_cone(const Cell& cell) {
        if (!is_inside(cell)) {
            return;
        }
        Ids loop;
        const Edge* edge = cell.incident_edge();
        do {
            append(*edge, loop);
            edge = edge->next();
        } while (edge != cell.incident_edge());
        loop = reduced(loop);
        const std::uint32_t apex = at_start(cell) ? side_of(cell).from_id : side_of(cell).to_id;
        const auto at = std::find(loop.begin(), loop.end(), apex);
        if (at == loop.end() && loop.size() > 2) {
            throw std::runtime_error("a corner of the outline has no cell");
        }
        std::rotate(loop.begin(), at, loop.end());
        for (std::size_t i = 2; i < loop.size(); ++i) {
            mesh_.triangles.emplace_back(loop[0], loop[i - 1], loop[i]);
        }
    }

    const GridOutline& outline_;
    Fineness fineness_;
    Mesh mesh_;
    PointIds known_;
    std::vector<Side> sides_;
    Diagram diagram_;
    Ids ids_;  ///< By vertex of the diagram.
    std::unordered_map<const Edge*, Ids> divisions_;
};

}  // namespace

Mesh voronoi_roof(std::span<const std::vector<glm::dvec2>> loops, const Fineness& fineness,
                  const std::stop_token& stop) {
    const GridOutline outline(loops);
    if (outline.loops().empty()) {
        return {};
    }
    base::end_if_asked(stop);
    Mesh mesh = Builder(outline, fineness).run();
    mesh.sources.assign(mesh.triangles.size(), 0);
    std::vector<glm::dvec3> normals;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3& a = mesh.points[t.x];
        normals.push_back(glm::cross(mesh.points[t.y] - a, mesh.points[t.z] - a));
    }
    base::end_if_asked(stop);
    separate_sheets(mesh, std::span<const glm::dvec3>(normals));
    if (!facts(mesh).manifold) {
        throw std::runtime_error("the roof does not close");
    }
    return mesh;
}

}  // namespace csg::reference
