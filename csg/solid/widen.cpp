#include "csg/solid/widen.h"

#include <algorithm>

#include "csg/solid/arrangement.h"
#include "csg/solid/outline_grid.h"
#include "csg/solid/raw_offset.h"
#include "csg/tree/finite.h"

namespace csg::solid {

Outline widen(std::span<const Loop> loops, const Widening& how) {
    OutlineGrid given;
    given.measure(loops);
    given.measure(how.distance);
    RawOffset offset(how, 1 / given.scale());
    std::vector<Loop> raw;
    OutlineGrid grid;
    for (const Loop& loop : loops) {
        if (!std::all_of(loop.begin(), loop.end(), is_finite<2>))
            continue;
        const Loop& moved = raw.emplace_back(offset.around(loop));
        if (!std::all_of(moved.begin(), moved.end(), is_finite<2>))
            throw OutlineError("an offset beyond what coordinates can hold");
    }
    grid.measure(raw);
    std::vector<GridEdge> edges;
    grid.add(raw, edges);
    return grid.read(boundary(arrange(std::move(edges)), [](int winding, int) { return winding > 0; }));
}

}  // namespace csg::solid
