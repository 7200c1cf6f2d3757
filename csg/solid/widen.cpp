#include "csg/solid/widen.h"

#include <algorithm>

#include "csg/solid/arrangement.h"
#include "csg/solid/outline_grid.h"
#include "csg/solid/raw_offset.h"
#include "csg/tree/finite.h"

namespace csg::solid {
namespace {

constexpr double kMuchCrossing = 1 << 14;
constexpr std::size_t kTogether = 32;

using Part = std::shared_ptr<const Outline>;

const Loop& checked(const Loop& loop) {
    if (!std::all_of(loop.begin(), loop.end(), is_finite<2>)) {
        throw OutlineError("an offset beyond what coordinates can hold");
    }
    return loop;
}

/// About how many edges cross: as many for each corner as quadrilaterals and joins lie above each other, were they
/// spread evenly; their areas add up to what the raw loops have more than the given ones.
double crossings(const Outline& given, const std::vector<Loop>& raw, double distance) {
    double swept = -given.area();
    for (const Loop& loop : raw) {
        swept += area2(loop) / 2;
    }
    // Miters may reach far beyond the box, but most lies within.
    const Box box = bounds_of(given.loops);
    const double reach = std::max(2 * distance, 0.0);
    return static_cast<double>(given.corners()) * std::abs(swept) /
           ((box.hi.x - box.lo.x + reach) * (box.hi.y - box.lo.y + reach));
}

/// What some edges of a loop, one after the other, sweep; the last of them is the first of the next part. So parts
/// overlap and leave no gaps where they are rounded.
void sweep_parts(const Loop& loop, RawOffset& offset, std::vector<Part>& parts) {
    for (std::size_t first = 0; first < loop.size(); first += kTogether) {
        Loop line;
        const std::size_t last = std::min(first + kTogether, loop.size()) + 1;
        for (std::size_t i = first; i <= last; ++i) {
            line.push_back(loop[i % loop.size()]);
        }
        const Loop band = checked(offset.beside(line));
        parts.push_back(std::make_shared<Outline>(clean(std::span(&band, 1), FillRule::NonZero)));
    }
}

/// Of many parts that overlap all over, by and by: most of what crosses is inside of what is near it.
Part unite(std::vector<Part> parts) {
    while (parts.size() > 1) {
        std::vector<Part> united;
        for (std::size_t i = 0; i < parts.size(); i += kTogether) {
            const std::size_t count = std::min(kTogether, parts.size() - i);
            united.push_back(
                std::make_shared<Outline>(combine(BooleanKind::Union, std::span(parts).subspan(i, count))));
        }
        parts = std::move(united);
    }
    return parts[0];
}

}  // namespace

Outline widen(std::span<const Loop> loops, const Widening& how) {
    OutlineGrid given;
    given.measure(loops);
    given.measure(how.distance);
    RawOffset offset(how, 1 / given.scale());
    auto finite = std::make_shared<Outline>();
    std::copy_if(loops.begin(), loops.end(), std::back_inserter(finite->loops),
                 [](const Loop& loop) { return std::all_of(loop.begin(), loop.end(), is_finite<2>); });
    std::vector<Loop> raw;
    for (const Loop& loop : finite->loops) {
        raw.push_back(checked(offset.around(loop)));
    }
    if (how.end == LineEnd::Closed && crossings(*finite, raw, how.distance) > kMuchCrossing) {
        std::vector<Part> parts;
        for (const Loop& loop : finite->loops) {
            sweep_parts(loop, offset, parts);
        }
        const Part swept = unite(std::move(parts));
        return combine(how.distance > 0 ? BooleanKind::Union : BooleanKind::Difference,
                       std::vector<Part>{finite, swept});
    }
    OutlineGrid grid;
    grid.measure(raw);
    std::vector<GridEdge> edges;
    grid.add(raw, edges);
    return grid.read(boundary(arrange(std::move(edges)), [](int winding, int) { return winding > 0; }));
}

}  // namespace csg::solid
