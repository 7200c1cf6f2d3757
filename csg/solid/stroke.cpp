#include "csg/solid/stroke.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/widen.h"
#include "csg/tree/degrees.h"
#include "csg/tree/finite.h"

namespace csg::solid {

Outline stroke(const Loop& line, const Stroke& how, int around) {
    if (line.empty() || !std::all_of(line.begin(), line.end(), is_finite<2>) || !(how.width > 0) ||
        !std::isfinite(how.width)) {
        return {};
    }
    Widening widening;
    widening.distance = how.width / 2;
    widening.tolerance = widening.distance * (1 - cos_degrees(180.0 / std::max(around, 3)));
    widening.miter_limit = std::max(how.miter_limit, 2.0);
    widening.join = how.join == Stroke::Join::Round   ? Join::Round
                    : how.join == Stroke::Join::Bevel ? Join::Square
                                                      : Join::Miter;
    widening.end = how.cap == Stroke::Cap::Butt    ? LineEnd::Butt
                   : how.cap == Stroke::Cap::Round ? LineEnd::Round
                                                   : LineEnd::Square;
    return widen(std::span(&line, 1), widening);
}

}  // namespace csg::solid
