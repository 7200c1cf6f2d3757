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
std::vector<PlaneCells> cells_of_planes(const solid::Geometry& geometry, const Content& content, const InsideRule& rule,
                                        unsigned threads, const std::stop_token& stop) {
    std::vector<PlaneCells> cells(content.planes.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        constexpr std::size_t kChunk = 16;
        for (std::size_t from; (from = next.fetch_add(kChunk)) < cells.size();) {
            for (std::size_t i = from; i < std::min(from + kChunk, cells.size()); ++i) {
                base::end_if_asked(stop);
                if (!content.planes[i].segments.empty())
                    cells[i] = make_cells(content, content.planes[i], geometry.planes.planes()[i].normal, rule);
            }
        }
    };
    base::on_threads(threads, static_cast<unsigned>(cells.size() / 64 + 1), work, [&] { next = cells.size(); });
    return cells;
}

}  // namespace

Mesh plane_boolean(const Scene& scene, const solid::Geometry& geometry, unsigned threads, const std::stop_token& stop) {
    const std::vector<LeafId> leaves = leaves_of(scene, geometry);
    if (leaves.empty())
        return {};
    const InsideRule rule(geometry);
    Content content = collect_segments(geometry, leaves, rule, stop);
    split_segments(geometry, content, stop);
    const PlaneSpace space(geometry, leaves, content.points);
    std::vector<PlaneCells> cells = cells_of_planes(geometry, content, rule, threads, stop);
    const CellComplex complex = make_complex(std::move(cells), space, rule, leaves, geometry.leaves.size(), stop);
    base::end_if_asked(stop);
    return surface(scene, leaves, complex, content.points.points().size(),
                   [&](std::uint32_t id) { return content.points[id]; });
}

}  // namespace csg::reference
