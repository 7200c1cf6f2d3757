#include "csg/reference/exact_boolean.h"

#include <atomic>

#include "base/stop.h"
#include "base/threads.h"
#include "csg/reference/cell_maker.h"
#include "csg/reference/collapse.h"
#include "csg/reference/complex_surface.h"
#include "csg/reference/exact_space.h"
#include "csg/reference/thin_pieces.h"

namespace csg::reference {
namespace {

/// A triangle that nothing meets is one cell.
PlaneCells whole(const ExactFace& face) {
    const auto [a, b, c] = face.corners;
    PlaneCells result;
    result.cells.push_back({{{face.leaf, 1}}, {{a, b, c}}});
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        result.sides.push_back({std::min(from, to), std::max(from, to), 0, from < to});
    }
    return result;
}

PlaneCells cells_of(const ExactSegments& segments, std::uint32_t plane, const ExactFace* alone,
                    const InsideRule& rule) {
    const ExactPlaneContent& content = segments.planes()[plane];
    PlaneEdges edges(rule);
    bool split = content.segments.size() != 3 || content.borders.size() != 3;
    const auto for_each_edge = [&](std::uint32_t segment, auto&& visit) {
        const std::vector<std::uint32_t> chain = segments.chain(segment);
        split |= chain.size() > 2;
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            visit(chain[i], chain[i + 1]);
        }
    };
    for (const std::uint32_t id : content.segments) {
        for_each_edge(id, [&](std::uint32_t a, std::uint32_t b) { edges.add(a, b); });
    }
    if (alone != nullptr && !split) {
        return whole(*alone);
    }
    for (const ExactBorder& border : content.borders) {
        for_each_edge(border.segment,
                      [&](std::uint32_t a, std::uint32_t b) { edges.add(a, b, border.leaf, border.count); });
    }
    return CellMaker<ExactKernel>(edges).make([&](std::uint32_t id) { return segments.picture(plane, id); });
}

/// Planes are independent of each other; numbers that they share are safe to be made more exact by several threads. The
/// result does not depend on their number.
std::vector<PlaneCells> cells_of_planes(const ExactFaces& faces, const ExactSegments& segments, const InsideRule& rule,
                                        unsigned threads, const std::stop_token& stop) {
    std::vector<std::uint32_t> faces_in(faces.planes.size(), 0);
    for (const ExactFace& face : faces.faces) {
        ++faces_in[face.plane];
    }
    std::vector<PlaneCells> cells(faces.planes.size());
    std::atomic<std::uint32_t> next{0};
    const auto work = [&] {
        for (std::uint32_t plane; (plane = next.fetch_add(1)) < cells.size();) {
            base::end_if_asked(stop);
            if (!segments.planes()[plane].segments.empty()) {
                cells[plane] = cells_of(segments, plane,
                                        faces_in[plane] == 1 ? &faces.faces[faces.planes[plane].face] : nullptr, rule);
            }
        }
    };
    base::on_threads(threads, static_cast<unsigned>(cells.size() / 64 + 1), work,
                     [&] { next = static_cast<std::uint32_t>(cells.size()); });
    return cells;
}

}  // namespace

Mesh exact_boolean(const LeafGroup& group, const GroupExpression& expression, unsigned threads,
                   const std::stop_token& stop) {
    const InsideRule rule(group);
    const ExactFaces faces = collect_faces(group, stop);
    const ExactSegments segments(faces, rule, stop);
    const ExactSpace space(faces, segments.points());
    const CellComplex complex = make_complex(cells_of_planes(faces, segments, rule, threads, stop), space, stop);
    const RegionValues values = evaluate_regions(complex, expression, rule, stop);
    Mesh mesh = surface(
        complex, values, segments.points().size(), [&](std::uint32_t id) { return segments.points().rounded(id); },
        [&](std::uint32_t plane) {
            const ExactFace& face = faces.faces[faces.planes[plane].face];
            const glm::dvec3& a = faces.corner(face, 0);
            return glm::cross(faces.corner(face, 1) - a, faces.corner(face, 2) - a);
        },
        stop);
    collapse_empty_edges(mesh);
    drop_thin_pieces(mesh);
    return mesh;
}

}  // namespace csg::reference
