#include "csg/reference/leaf_groups.h"

#include <algorithm>
#include <unordered_map>

#include "base/stop.h"
#include "csg/reference/box_pairs.h"
#include "csg/reference/disjoint_sets.h"
#include "csg/reference/leaf_pieces.h"
#include "csg/solid/plane_table.h"

namespace csg::reference {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
/// What is subtracted is copied to the groups that it meets as long as all copies together have no more triangles than
/// this times those of the scene.
constexpr std::size_t kMostCopies = 4;

/// Wide against the distance within which points are one (segments.h).
double margin_of(const Box& box) {
    const glm::dvec3 largest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    return 8 * solid::coincidence_tolerance(std::max({largest.x, largest.y, largest.z}));
}

}  // namespace

LeafGroups::LeafGroups(const Scene& scene, const solid::Geometry& geometry, std::span<const LeafId> leaves,
                       const std::stop_token& stop)
    : scene_(scene), geometry_(geometry) {
    if (leaves.empty()) {
        return;
    }
    make_units(leaves, margin_of(geometry.box), stop);
    make_groups(stop);
}

/// `boxes`: of the expressions, cut down to those of what they are in.
void LeafGroups::look_above(std::span<const Box> leaf_boxes, std::vector<Box>& boxes) {
    const auto root = static_cast<std::uint32_t>(scene_.expressions.size());
    above_.resize(root + 1);
    boxes.resize(root);
    node_of_.assign(scene_.leaves.size(), kNone);
    for (const PartId id : solid_parts(scene_)) {
        const Part& part = scene_.parts[id];
        const std::vector<Box> own = expression_boxes(scene_, part, leaf_boxes);
        std::copy(own.begin(), own.end(), boxes.begin() + part.first_expression);
        above_[part.root].parent = root;
        for (std::uint32_t i = part.root + 1; i-- > part.first_expression;) {
            const Expression& e = scene_.expressions[i];
            const Above above = above_[i];
            if (above.parent == kNone) {
                continue;
            }
            if (e.kind == ExpressionKind::Leaf) {
                node_of_[e.leaf] = i;
            }
            const bool in_union =
                above.parent == root || scene_.expressions[above.parent].kind == ExpressionKind::Union;
            const auto children = scene_.children(e);
            for (std::size_t c = 0; c < children.size(); ++c) {
                const bool subtracted = e.kind == ExpressionKind::Difference && c > 0;
                Above& below = above_[children[c]];
                below.parent = e.kind == ExpressionKind::Union && in_union ? above.parent : i;
                below.first = c == 0;
                below.complement = above.complement != subtracted;
                below.carried = above.carried && !subtracted;
                below.plain =
                    above.plain && !subtracted && (e.kind != ExpressionKind::Intersection || children.size() == 1);
                boxes[children[c]] = intersect(boxes[children[c]], boxes[i]);
            }
        }
    }
}

void LeafGroups::make_units(std::span<const LeafId> leaves, double margin, const std::stop_token& stop) {
    std::vector<Box> leaf_boxes(scene_.leaves.size());
    for (const LeafId leaf : leaves) {
        const Box& box = geometry_.leaves[leaf].box;
        leaf_boxes[leaf] = {box.lo - margin, box.hi + margin};
    }
    std::vector<Box> boxes;
    look_above(leaf_boxes, boxes);
    for (const LeafId leaf : leaves) {
        base::end_if_asked(stop);
        const solid::PlacedLeaf& placed = geometry_.leaves[leaf];
        const Box& box = boxes[node_of_[leaf]];
        if (box.empty()) {
            continue;
        }
        std::vector<solid::PlacedLeaf> pieces;
        if (!placed.solid->convex) {
            pieces = pieces_of(placed, margin, stop);
        }
        if (pieces.empty()) {
            units_.push_back({leaf, &placed, box});
            continue;
        }
        pieces_.push_back(std::move(pieces));
        for (const solid::PlacedLeaf& piece : pieces_.back()) {
            const Box own = intersect({piece.box.lo - margin, piece.box.hi + margin}, box);
            if (!own.empty()) {
                units_.push_back({leaf, &piece, own});
            }
        }
    }
}

void LeafGroups::make_groups(const std::stop_token& stop) {
    std::vector<std::uint32_t> carried, others;
    std::vector<Box> boxes;
    std::size_t triangles = 0;
    for (std::uint32_t i = 0; i < units_.size(); ++i) {
        triangles += units_[i].placed->triangles.size();
        if (!above_[node_of_[units_[i].leaf]].carried) {
            others.push_back(i);
            continue;
        }
        carried.push_back(i);
        boxes.push_back(units_[i].box);
        extent_ = enclose(extent_, units_[i].box);
    }
    if (carried.empty()) {
        return;
    }
    base::PacedStop paced(stop);
    const BoxTree tree(boxes);
    DisjointSets sets = meeting_sets(tree, stop);
    // Pairs of what is subtracted and a carried unit of each group that it meets.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> copies;
    std::size_t copied = 0;
    std::vector<std::uint32_t> met;
    for (const std::uint32_t other : others) {
        met.clear();
        tree.meeting(units_[other].box, [&](std::uint32_t i) {
            paced();
            met.push_back(sets.find(i));
        });
        std::sort(met.begin(), met.end());
        met.erase(std::unique(met.begin(), met.end()), met.end());
        if (met.empty()) {
            continue;
        }
        const std::size_t more = (met.size() - 1) * units_[other].placed->triangles.size();
        if (copied + more > kMostCopies * triangles) {
            for (const std::uint32_t group : met) {
                sets.unite(std::max(group, met[0]), std::min(group, met[0]));
            }
            met.erase(met.begin() + 1, met.end());
        } else {
            copied += more;
        }
        for (const std::uint32_t group : met) {
            copies.emplace_back(group, other);
        }
    }
    SetNumbers number(sets);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> members;  // group, unit
    members.reserve(carried.size() + copies.size());
    for (std::uint32_t i = 0; i < carried.size(); ++i) {
        members.emplace_back(number(i), carried[i]);
    }
    for (const auto& [at, unit] : copies) {
        members.emplace_back(number(at), unit);
    }
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    first_.assign(number.count() + 1, 0);
    for (const auto& [group, unit] : members) {
        ++first_[group + 1];
        members_.push_back(unit);
    }
    for (std::uint32_t g = 0; g < number.count(); ++g) {
        first_[g + 1] += first_[g];
    }
}

std::size_t LeafGroups::triangles(std::size_t group) const {
    std::size_t count = 0;
    for (std::uint32_t i = first_[group]; i < first_[group + 1]; ++i) {
        count += units_[members_[i]].placed->triangles.size();
    }
    return count;
}

LeafGroups::Alone LeafGroups::alone(std::size_t group) const {
    const Unit& unit = units_[members_[first_[group]]];
    if (first_[group + 1] - first_[group] != 1 || !above_[node_of_[unit.leaf]].plain) {
        return {};
    }
    return {unit.placed, unit.leaf};
}

CombinedLeaves LeafGroups::combined(std::size_t group) const {
    CombinedLeaves result;
    result.group.planes = geometry_.planes.planes();
    result.group.extent = geometry_.box;
    std::vector<GroupExpression::Node>& nodes = result.expression.nodes;
    const auto root = static_cast<std::uint32_t>(scene_.expressions.size());
    std::unordered_map<std::uint32_t, std::uint32_t> number;
    const auto make_node = [&](std::uint32_t of) {
        const Above& above = above_[of];
        const bool whole = of == root;
        nodes.push_back({whole ? ExpressionKind::Union : scene_.expressions[of].kind, GroupExpression::kNone,
                         whole ? 0 : scene_.expressions[of].child_count, above.first, above.complement});
        return static_cast<std::uint32_t>(nodes.size() - 1);
    };
    for (std::uint32_t i = first_[group]; i < first_[group + 1]; ++i) {
        const Unit& unit = units_[members_[i]];
        result.group.leaves.push_back(unit.placed);
        result.sources.push_back(unit.leaf);
        // Pieces of one leaf are a union of them.
        std::uint32_t below = make_node(node_of_[unit.leaf]);
        result.expression.leaves.push_back(below);
        const bool is_piece = unit.placed != &geometry_.leaves[unit.leaf];
        for (std::uint32_t of = is_piece ? node_of_[unit.leaf] : above_[node_of_[unit.leaf]].parent; of != kNone;
             of = above_[of].parent) {
            const auto [at, added] = number.try_emplace(of, 0);
            if (added) {
                at->second = make_node(of);
            }
            nodes[below].parent = at->second;
            if (!added) {
                break;
            }
            below = at->second;
        }
    }
    return result;
}

}  // namespace csg::reference
