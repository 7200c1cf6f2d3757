#include "csg/reference/plane_boolean.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

#include "csg/reference/cell_complex.h"
#include "csg/reference/expression_value.h"
#include "csg/reference/manifold.h"

namespace csg::reference {
namespace {

std::vector<LeafId> leaves_of(const Scene& scene, const solid::Geometry& geometry) {
    std::vector<LeafId> leaves;
    for (const PartId part : solid_parts(scene)) {
        const Part& p = scene.parts[part];
        for (LeafId leaf = p.first_leaf; leaf < p.first_leaf + p.leaf_count; ++leaf) {
            if (!geometry.leaves[leaf].triangles.empty())
                leaves.push_back(leaf);
        }
    }
    std::sort(leaves.begin(), leaves.end());
    return leaves;
}

/// Planes are independent of each other; the result does not depend on the number of threads.
std::vector<PlaneCells> cells_of_planes(const solid::Geometry& geometry, const Content& content, unsigned threads) {
    std::vector<PlaneCells> cells(content.planes.size());
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::atomic_flag failed = ATOMIC_FLAG_INIT;
    const auto work = [&] {
        try {
            constexpr std::size_t kChunk = 16;
            for (std::size_t from; (from = next.fetch_add(kChunk)) < cells.size();) {
                for (std::size_t i = from; i < std::min(from + kChunk, cells.size()); ++i) {
                    if (!content.planes[i].segments.empty())
                        cells[i] = make_cells(content, content.planes[i], geometry.planes.planes()[i].normal);
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

/// The cells on the surface, as triangles that face outwards.
Mesh surface(const Scene& scene, const solid::Geometry& geometry, const std::vector<LeafId>& leaves,
             const CellComplex& complex, const PointTable& points) {
    ExpressionValue expression(scene);
    std::vector<std::uint32_t> index(scene.leaves.size(), ~std::uint32_t{0});
    for (std::uint32_t i = 0; i < leaves.size(); ++i)
        index[leaves[i]] = i;
    const auto evaluate = [&](std::uint32_t region) {
        const auto bits = complex.holders(region);
        return expression.evaluate([&](LeafId leaf) {
            const std::uint32_t i = index[leaf];
            return i != ~std::uint32_t{0} && (bits[i / 64] >> (i % 64) & 1) != 0;
        });
    };
    std::vector<char> solid(complex.regions);
    for (std::uint32_t r = 0; r < complex.regions; ++r)
        solid[r] = evaluate(r);
    // By the region on the solid's side, so that each is evaluated once more at most.
    std::vector<std::uint32_t> kept;
    const auto inner = [&](std::uint32_t c) {
        const ComplexCell& cell = complex.cells[c];
        return solid[cell.above] != 0 ? cell.above : cell.below;
    };
    for (std::uint32_t c = 0; c < complex.cells.size(); ++c) {
        if (solid[complex.cells[c].above] != solid[complex.cells[c].below])
            kept.push_back(c);
    }
    std::vector<LeafId> owners(complex.cells.size());
    std::vector<std::uint32_t> by_region = kept;
    std::stable_sort(by_region.begin(), by_region.end(), [&](auto a, auto b) { return inner(a) < inner(b); });
    std::uint32_t evaluated = ~std::uint32_t{0};
    for (const std::uint32_t c : by_region) {
        if (complex.cells[c].leaves.size() == 1) {
            owners[c] = complex.cells[c].leaves[0];
            continue;
        }
        if (evaluated != inner(c))
            (void)evaluate(evaluated = inner(c));
        owners[c] = expression.owner(complex.cells[c].leaves);
    }
    Mesh mesh;
    mesh.points = points.points();
    std::vector<glm::dvec3> normals;
    for (const std::uint32_t c : kept) {
        const ComplexCell& cell = complex.cells[c];
        const bool turned = solid[cell.above] != 0;
        const glm::dvec3 normal = geometry.planes.planes()[cell.plane].normal;
        for (glm::uvec3 t : cell.triangles) {
            if (turned)
                std::swap(t.y, t.z);
            mesh.triangles.push_back(t);
            mesh.sources.push_back(owners[c]);
            normals.push_back(turned ? -normal : normal);
        }
    }
    separate_sheets(mesh, std::move(normals));
    return mesh;
}

}  // namespace

Mesh plane_boolean(const Scene& scene, const solid::Geometry& geometry, unsigned threads) {
    const std::vector<LeafId> leaves = leaves_of(scene, geometry);
    if (leaves.empty())
        return {};
    Content content = collect_segments(geometry, leaves);
    split_segments(geometry, content);
    const CellComplex complex =
        make_complex(geometry, leaves, content.points, cells_of_planes(geometry, content, threads));
    return surface(scene, geometry, leaves, complex, content.points);
}

}  // namespace csg::reference
