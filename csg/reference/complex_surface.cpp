#include "csg/reference/complex_surface.h"

#include <algorithm>
#include <tuple>

#include "csg/reference/expression_value.h"
#include "csg/reference/manifold.h"

namespace csg::reference {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

class SurfaceMaker {
  public:
    SurfaceMaker(const Scene& scene, std::span<const LeafId> leaves, const CellComplex& complex)
        : expression_(scene), takes_part_(scene.leaves.size(), 0), complex_(complex) {
        for (const LeafId leaf : leaves)
            takes_part_[leaf] = 1;
        for (std::uint32_t r = 0; r < complex_.regions; ++r)
            solid_.push_back(evaluate(r));
    }

    Mesh make(std::size_t points, const std::function<glm::dvec3(std::uint32_t)>& place) {
        std::vector<std::uint32_t> kept;
        for (std::uint32_t c = 0; c < complex_.cells.size(); ++c) {
            if (is_surface(complex_.cells[c]))
                kept.push_back(c);
        }
        const std::vector<LeafId> owners = find_owners(kept);
        Mesh mesh;
        std::vector<std::uint32_t> cell_of;
        for (std::size_t i = 0; i < kept.size(); ++i) {
            for (glm::uvec3 t : complex_.cells[kept[i]].triangles) {
                if (turned(complex_.cells[kept[i]]))
                    std::swap(t.y, t.z);
                mesh.triangles.push_back(t);
                mesh.sources.push_back(owners[i]);
                cell_of.push_back(kept[i]);
            }
        }
        std::vector<char> placed(points, 0);
        mesh.points.resize(points);
        for (const glm::uvec3& t : mesh.triangles) {
            for (int k = 0; k < 3; ++k) {
                if (placed[t[k]] == 0)
                    mesh.points[t[k]] = place(t[k]);
                placed[t[k]] = 1;
            }
        }
        separate_sheets(mesh, turns(mesh, cell_of));
        return mesh;
    }

  private:
    bool evaluate(std::uint32_t region) {
        return expression_.evaluate(
            [&](LeafId leaf) { return takes_part_[leaf] != 0 && complex_.windings.inside(region, leaf); });
    }

    [[nodiscard]] bool is_surface(const ComplexCell& cell) const { return solid_[cell.above] != solid_[cell.below]; }
    [[nodiscard]] bool turned(const ComplexCell& cell) const { return solid_[cell.above] != 0; }

    /// By region on the solid's side, so that each is evaluated once more at most.
    std::vector<LeafId> find_owners(const std::vector<std::uint32_t>& kept) {
        const auto inner = [&](std::uint32_t c) {
            const ComplexCell& cell = complex_.cells[c];
            return turned(cell) ? cell.above : cell.below;
        };
        std::vector<std::uint32_t> order(kept.size());
        for (std::uint32_t i = 0; i < order.size(); ++i)
            order[i] = i;
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return inner(kept[a]) < inner(kept[b]); });
        std::vector<LeafId> owners(kept.size()), switching;
        std::uint32_t evaluated = kNone;
        for (const std::uint32_t i : order) {
            const ComplexCell& cell = complex_.cells[kept[i]];
            switching.clear();
            for (const Cover& c : cell.covers) {
                if (complex_.windings.inside(cell.above, c.leaf) != complex_.windings.inside(cell.below, c.leaf))
                    switching.push_back(c.leaf);
            }
            if (switching.size() > 1 && evaluated != inner(kept[i]))
                (void)evaluate(evaluated = inner(kept[i]));
            owners[i] = switching.size() > 1 ? expression_.owner(switching) : switching.at(0);
        }
        return owners;
    }

    /// For the corners of triangles (manifold.h): places around those edges at which more than two sides are surface.
    [[nodiscard]] std::vector<double> turns(const Mesh& mesh, const std::vector<std::uint32_t>& cell_of) const {
        const std::vector<ComplexSide>& sides = complex_.sides;
        struct Place {
            std::uint32_t lo, hi, cell, left;
            double turn;
        };
        std::vector<Place> places;
        for (std::size_t i = 0, j; i < sides.size(); i = j) {
            std::size_t count = 0;
            for (j = i; j < sides.size() && sides[j].lo == sides[i].lo && sides[j].hi == sides[i].hi; ++j)
                count += is_surface(complex_.cells[sides[j].cell]) ? 1 : 0;
            for (std::size_t k = i; k < j && count > 2; ++k)
                places.push_back(
                    {sides[k].lo, sides[k].hi, sides[k].cell, sides[k].left ? 1u : 0u, static_cast<double>(k - i) + 1});
        }
        std::vector<double> result;
        if (places.empty())
            return result;
        const auto key = [](const Place& p) { return std::tie(p.lo, p.hi, p.cell, p.left); };
        std::sort(places.begin(), places.end(), [&](const Place& a, const Place& b) { return key(a) < key(b); });
        result.resize(3 * mesh.triangles.size());
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
                const bool left = (a < b) != turned(complex_.cells[cell_of[t]]);
                const Place sought{std::min(a, b), std::max(a, b), cell_of[t], left ? 1u : 0u, 0};
                const auto at = std::lower_bound(places.begin(), places.end(), sought,
                                                 [&](const Place& p, const Place& q) { return key(p) < key(q); });
                if (at != places.end() && key(*at) == key(sought))
                    result[3 * t + static_cast<std::size_t>(k)] = at->turn;
            }
        }
        return result;
    }

    ExpressionValue expression_;
    std::vector<char> takes_part_;  ///< By leaf.
    const CellComplex& complex_;
    std::vector<char> solid_;  ///< By region.
};

}  // namespace

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

Mesh surface(const Scene& scene, std::span<const LeafId> leaves, const CellComplex& complex, std::size_t points,
             const std::function<glm::dvec3(std::uint32_t)>& place) {
    return SurfaceMaker(scene, leaves, complex).make(points, place);
}

}  // namespace csg::reference
