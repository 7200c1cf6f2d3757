// Where the faces that a leaf has in a plane end.
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include "csg/reference/winding.h"

namespace csg::reference {

/// A triangle in a plane has the edge between points lo < hi.
struct EdgeUse {
    std::uint32_t lo, hi;
    std::uint32_t plane;
    std::int32_t count;  ///< 1 where it runs from lo to hi, −1 where from hi to lo.
};

[[nodiscard]] inline EdgeUse edge_use(std::uint32_t from, std::uint32_t to, std::uint32_t plane) {
    return {std::min(from, to), std::max(from, to), plane, from < to ? 1 : -1};
}

/// `uses` are those of all triangles of one leaf. Calls `visit(lo, hi, plane, count)` where its triangles in the plane
/// pass an edge more often in one direction than in the other (count: by so much from lo to hi), and with a count of 0
/// where they do not, but triangles in other planes end at that edge, too: then it is an edge in all of them.
template <typename Visit>
void visit_borders(std::vector<EdgeUse>& uses, LeafId leaf, const InsideRule& rule, Visit&& visit) {
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
        return std::tie(a.lo, a.hi, a.plane, a.count) < std::tie(b.lo, b.hi, b.plane, b.count);
    });
    for (std::size_t i = 0, end; i < uses.size(); i = end) {
        for (end = i + 1; end < uses.size() && uses[end].lo == uses[i].lo && uses[end].hi == uses[i].hi; ++end) {
        }
        const bool one_plane = uses[i].plane == uses[end - 1].plane;
        for (std::size_t j = i, k; j < end; j = k) {
            std::int32_t count = 0;
            for (k = j; k < end && uses[k].plane == uses[j].plane; ++k) {
                count += uses[k].count;
            }
            count = rule.reduced(leaf, count);
            if (count != 0 || !one_plane) {
                visit(uses[i].lo, uses[i].hi, uses[j].plane, count);
            }
        }
    }
}

}  // namespace csg::reference
