// Pairs of boxes in a plane that meet, by a sweep.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <vector>

namespace csg::reference {

/// Calls `visit(other, item)` for each pair of items whose boxes (`lo`, `hi`) meet along the shorter axis of all among
/// those that are met along the longer one; sorts the items along that, by `number(item)` where they begin alike.
/// `step()` is called for each pair looked at.
template <typename Item, typename Number, typename Step, typename Visit>
void sweep_pairs(std::vector<Item>& items, Number&& number, Step&& step, Visit&& visit) {
    glm::dvec2 lo(1e300), hi(-1e300);
    for (const Item& item : items) {
        lo = glm::min(lo, item.lo);
        hi = glm::max(hi, item.hi);
    }
    const int axis = hi.x - lo.x >= hi.y - lo.y ? 0 : 1;
    std::sort(items.begin(), items.end(), [&](const Item& a, const Item& b) {
        return a.lo[axis] != b.lo[axis] ? a.lo[axis] < b.lo[axis] : number(a) < number(b);
    });
    std::vector<const Item*> active;
    for (const Item& item : items) {
        std::erase_if(active, [&](const Item* other) { return other->hi[axis] < item.lo[axis]; });
        for (const Item* other : active) {
            step();
            if (other->lo[1 - axis] <= item.hi[1 - axis] && item.lo[1 - axis] <= other->hi[1 - axis]) {
                visit(*other, item);
            }
        }
        active.push_back(&item);
    }
}

}  // namespace csg::reference
