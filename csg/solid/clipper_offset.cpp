#include "csg/solid/clipper_offset.h"

#include <cmath>
#include <polyclipping/clipper.hpp>

#include "csg/solid/outline_grid.h"

namespace csg::solid {
namespace {

ClipperLib::JoinType clipper_join(Join join) {
    switch (join) {
        case Join::Miter:
            return ClipperLib::jtMiter;
        case Join::Square:
            return ClipperLib::jtSquare;
        case Join::Round:
            break;
    }
    return ClipperLib::jtRound;
}

ClipperLib::EndType clipper_end(LineEnd end) {
    switch (end) {
        case LineEnd::Butt:
            return ClipperLib::etOpenButt;
        case LineEnd::Round:
            return ClipperLib::etOpenRound;
        case LineEnd::Square:
            return ClipperLib::etOpenSquare;
        case LineEnd::Closed:
            break;
    }
    return ClipperLib::etClosedPolygon;
}

}  // namespace

Outline widen(std::span<const Loop> loops, const Widening& how) {
    OutlineGrid grid;
    grid.measure(loops);
    grid.measure(how.distance);
    ClipperLib::ClipperOffset clipper(how.miter_limit, how.tolerance * grid.scale());
    ClipperLib::Paths widened;
    try {
        for (const Loop& loop : loops) {
            ClipperLib::Path path;
            for (const GridPoint& p : grid.loop(loop))
                path.emplace_back(p.x, p.y);
            clipper.AddPath(path, clipper_join(how.join), clipper_end(how.end));
        }
        clipper.Execute(widened, how.distance * grid.scale());
    } catch (const ClipperLib::clipperException& error) {
        throw OutlineError(error.what());
    }
    // Clipper's result touches itself, its rounding moves points over edges, and where loops touch it may take one for
    // a hole that is none; but an odd number of them is around what is inside.
    std::vector<Loop> result;
    for (const ClipperLib::Path& path : widened) {
        Loop& loop = result.emplace_back();
        for (const ClipperLib::IntPoint& p : path)
            loop.push_back(grid.point({p.X, p.Y}));
    }
    return clean(result, FillRule::EvenOdd);
}

}  // namespace csg::solid
