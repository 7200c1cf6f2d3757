#include "csg/solid/stroke.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/clip_grid.h"
#include "csg/tree/degrees.h"
#include "csg/tree/finite.h"

namespace csg::solid {

Outline stroke(const Loop& line, const Stroke& how, int around) {
    if (line.empty() || !std::all_of(line.begin(), line.end(), is_finite<2>) || !(how.width > 0) ||
        !std::isfinite(how.width))
        return {};
    const double radius = how.width / 2;
    ClipGrid grid;
    grid.measure(std::span(&line, 1));
    grid.measure(radius);
    const double tolerance = radius * (1 - cos_degrees(180.0 / std::max(around, 3)));
    ClipperLib::ClipperOffset clipper(std::max(how.miter_limit, 2.0), tolerance * grid.scale());
    const ClipperLib::JoinType join = how.join == Stroke::Join::Round   ? ClipperLib::jtRound
                                      : how.join == Stroke::Join::Bevel ? ClipperLib::jtSquare
                                                                        : ClipperLib::jtMiter;
    const ClipperLib::EndType cap = how.cap == Stroke::Cap::Butt    ? ClipperLib::etOpenButt
                                    : how.cap == Stroke::Cap::Round ? ClipperLib::etOpenRound
                                                                    : ClipperLib::etOpenSquare;
    clipper.AddPath(grid.path(line), join, cap);
    ClipperLib::Paths result;
    try {
        clipper.Execute(result, radius * grid.scale());
    } catch (const ClipperLib::clipperException& error) {
        throw OutlineError(error.what());
    }
    return grid.read(result);
}

}  // namespace csg::solid
