#include "csg/reference/plane_boolean.h"

#include <algorithm>
#include <atomic>

#include "base/stop.h"
#include "base/threads.h"
#include "csg/reference/complex_surface.h"
#include "csg/reference/plane_space.h"

namespace csg::reference {
namespace {

/// Planes are independent of each other; the result does not depend on the number of threads.
std::vector<PlaneCells> cells_of_planes(const Content& content, const InsideRule& rule, unsigned threads,
                                        const std::stop_token& stop) {
    std::vector<PlaneCells> cells(content.planes.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        constexpr std::size_t kChunk = 16;
        for (std::size_t from; (from = next.fetch_add(kChunk)) < cells.size();) {
            for (std::size_t i = from; i < std::min(from + kChunk, cells.size()); ++i) {
                base::end_if_asked(stop);
                if (!content.planes[i].segments.empty()) {
                    cells[i] = make_cells(content, content.planes[i], rule);
                }
            }
        }
    };
    base::on_threads(threads, static_cast<unsigned>(cells.size() / 64 + 1), work, [&] { next = cells.size(); });
    return cells;
}

}  // namespace

Mesh plane_boolean(const LeafGroup& group, const GroupExpression& expression, unsigned threads,
                   const std::stop_token& stop) {
    const InsideRule rule(group);
    Content content = collect_segments(group, rule, stop);
    split_segments(content, stop);
    const PlaneSpace space(group, content);
    const CellComplex complex = make_complex(cells_of_planes(content, rule, threads, stop), space, stop);
    const RegionValues values = evaluate_regions(complex, expression, rule, stop);
    return surface(
        complex, values, content.points.points().size(), [&](std::uint32_t id) { return content.points[id]; },
        [&](std::uint32_t plane) { return content.planes[plane].plane.normal; }, stop);
}

}  // namespace csg::reference
