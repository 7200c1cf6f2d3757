#include "csg/reference/plane_boolean.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

#include "base/stop.h"
#include "csg/reference/complex_surface.h"
#include "csg/reference/plane_space.h"

namespace csg::reference {
namespace {

/// Planes are independent of each other; the result does not depend on the number of threads.
std::vector<PlaneCells> cells_of_planes(const solid::Geometry& geometry, const Content& content, const InsideRule& rule,
                                        unsigned threads, const std::stop_token& stop) {
    std::vector<PlaneCells> cells(content.planes.size());
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::atomic_flag failed = ATOMIC_FLAG_INIT;
    const auto work = [&] {
        try {
            constexpr std::size_t kChunk = 16;
            for (std::size_t from; (from = next.fetch_add(kChunk)) < cells.size();) {
                for (std::size_t i = from; i < std::min(from + kChunk, cells.size()); ++i) {
                    base::end_if_asked(stop);
                    if (!content.planes[i].segments.empty())
                        cells[i] = make_cells(content, content.planes[i], geometry.planes.planes()[i].normal, rule);
                }
            }
        } catch (...) {
            next = cells.size();
            if (!failed.test_and_set())
                failure = std::current_exception();
        }
    };
    const std::size_t most = cells.size() / 64 + 1;
    threads = threads == 0 ? std::max(1u, std::thread::hardware_concurrency()) : threads;
    {
        std::vector<std::jthread> helpers;
        for (std::size_t i = 1; i < std::min<std::size_t>(threads, most); ++i)
            helpers.emplace_back(work);
        work();
    }
    if (failure)
        std::rethrow_exception(failure);
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
