#include "csg/reference/exact_boolean.h"

#include "base/stop.h"
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
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        result.sides.push_back({std::min(from, to), std::max(from, to), 0, from < to});
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
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            visit(chain[i], chain[i + 1]);
    };
    for (const std::uint32_t id : content.segments)
        for_each_edge(id, [&](std::uint32_t a, std::uint32_t b) { edges.add(a, b); });
    if (alone != nullptr && !split)
        return whole(*alone);
    for (const ExactBorder& border : content.borders)
        for_each_edge(border.segment,
                      [&](std::uint32_t a, std::uint32_t b) { edges.add(a, b, border.leaf, border.count); });
    return CellMaker<ExactKernel>(edges).make([&](std::uint32_t id) { return segments.picture(plane, id); });
}

}  // namespace

Mesh exact_boolean(const Scene& scene, const solid::Geometry& geometry, const std::stop_token& stop) {
    const std::vector<LeafId> leaves = leaves_of(scene, geometry);
    if (leaves.empty())
        return {};
    const InsideRule rule(geometry);
    const ExactFaces faces = collect_faces(geometry, leaves, stop);
    const ExactSegments segments(faces, rule, stop);
    std::vector<std::uint32_t> faces_in(faces.planes.size(), 0);
    for (const ExactFace& face : faces.faces)
        ++faces_in[face.plane];
    std::vector<PlaneCells> cells(faces.planes.size());
    for (std::uint32_t plane = 0; plane < cells.size(); ++plane) {
        base::end_if_asked(stop);
        if (!segments.planes()[plane].segments.empty())
            cells[plane] = cells_of(segments, plane,
                                    faces_in[plane] == 1 ? &faces.faces[faces.planes[plane].face] : nullptr, rule);
    }
    const ExactSpace space(faces, segments.points());
    const CellComplex complex = make_complex(std::move(cells), space, rule, leaves, geometry.leaves.size(), stop);
    Mesh mesh = surface(scene, leaves, complex, segments.points().size(),
                        [&](std::uint32_t id) { return segments.points().rounded(id); });
    collapse_empty_edges(mesh);
    drop_thin_pieces(mesh);
    return mesh;
}

}  // namespace csg::reference
