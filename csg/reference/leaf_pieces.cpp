#include "csg/reference/leaf_pieces.h"

#include "base/stop.h"
#include "csg/reference/box_pairs.h"
#include "csg/reference/disjoint_sets.h"
#include "csg/reference/point_ids.h"

namespace csg::reference {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// By triangle.
std::uint32_t number_shells(const solid::PlacedLeaf& leaf, std::vector<std::uint32_t>& shell_of,
                            const std::stop_token& stop) {
    base::PacedStop paced(stop);
    PointIds ids;
    std::vector<std::uint32_t> id;
    id.reserve(leaf.points.size());
    for (const glm::dvec3& p : leaf.points) {
        paced();
        id.push_back(ids.add(p).first);
    }
    DisjointSets points(leaf.points.size());
    for (const glm::uvec3& t : leaf.triangles) {
        points.unite(id[t.y], id[t.x]);
        points.unite(id[t.z], id[t.x]);
    }
    SetNumbers shell(points);
    shell_of.reserve(leaf.triangles.size());
    for (const glm::uvec3& t : leaf.triangles) {
        shell_of.push_back(shell(id[t.x]));
    }
    return shell.count();
}

}  // namespace

std::vector<solid::PlacedLeaf> pieces_of(const solid::PlacedLeaf& leaf, double margin, const std::stop_token& stop) {
    std::vector<std::uint32_t> shell_of;
    const std::uint32_t shells = number_shells(leaf, shell_of, stop);
    if (shells < 2) {
        return {};
    }
    std::vector<Box> boxes(shells);
    for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            boxes[shell_of[t]] = enclose(boxes[shell_of[t]], leaf.points[leaf.triangles[t][k]]);
        }
    }
    for (Box& box : boxes) {
        box = {box.lo - margin, box.hi + margin};
    }
    DisjointSets sets = meeting_sets(BoxTree(boxes), stop);
    SetNumbers piece(sets);
    std::vector<std::uint32_t> piece_of;
    for (std::uint32_t i = 0; i < shells; ++i) {
        piece_of.push_back(piece(i));
    }
    if (piece.count() < 2) {
        return {};
    }
    base::end_if_asked(stop);
    std::vector<solid::PlacedLeaf> pieces(piece.count());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> number(leaf.points.size(), {kNone, kNone});  // piece, point
    for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
        const std::uint32_t at = piece_of[shell_of[t]];
        solid::PlacedLeaf& to = pieces[at];
        glm::uvec3 own;
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t point = leaf.triangles[t][k];
            if (number[point].first != at) {
                number[point] = {at, static_cast<std::uint32_t>(to.points.size())};
                to.points.push_back(leaf.points[point]);
                to.box = enclose(to.box, leaf.points[point]);
            }
            own[k] = number[point].second;
        }
        to.triangles.push_back(own);
        to.planes.push_back(leaf.planes[t]);
        to.solid = leaf.solid;
    }
    return pieces;
}

}  // namespace csg::reference
