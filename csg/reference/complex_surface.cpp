#include "csg/reference/complex_surface.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "csg/reference/flat_areas.h"
#include "csg/reference/manifold.h"

namespace csg::reference {
namespace {

class SurfaceMaker {
  public:
    SurfaceMaker(const CellComplex& complex, const RegionValues& values) : complex_(complex), values_(values) {}

    Mesh make(std::size_t points, const std::function<glm::dvec3(std::uint32_t)>& place,
              const std::function<glm::dvec3(std::uint32_t)>& normal, const std::stop_token& stop) {
        Mesh mesh;
        std::vector<std::uint32_t> cell_of;
        Kinds kinds;
        for (std::uint32_t c = 0; c < complex_.cells.size(); ++c) {
            if (!is_surface(complex_.cells[c])) {
                continue;
            }
            const std::uint32_t kind = kinds.of(complex_.cells[c].plane, turned(complex_.cells[c]), values_.owners[c]);
            for (glm::uvec3 t : complex_.cells[c].triangles) {
                if (turned(complex_.cells[c])) {
                    std::swap(t.y, t.z);
                }
                mesh.triangles.push_back(t);
                mesh.sources.push_back(kind);
                cell_of.push_back(c);
            }
        }
        std::vector<char> placed(points, 0);
        mesh.points.resize(points);
        for (const glm::uvec3& t : mesh.triangles) {
            for (int k = 0; k < 3; ++k) {
                if (placed[t[k]] == 0) {
                    mesh.points[t[k]] = place(t[k]);
                }
                placed[t[k]] = 1;
            }
        }
        separate_sheets(mesh, turns(mesh, cell_of));
        std::vector<glm::dvec3> normals;
        for (const Kinds::Kind& kind : kinds.all) {
            normals.push_back(normal(kind.plane) * (kind.turned ? -1.0 : 1.0));
        }
        merge_flat_areas(mesh, normals, stop);
        for (std::uint32_t& source : mesh.sources) {
            source = kinds.all[source].owner;
        }
        return mesh;
    }

  private:
    /// Of triangles that are one area where they are neighbors.
    struct Kinds {
        struct Kind {
            std::uint32_t plane;
            bool turned;
            LeafId owner;
        };
        std::uint32_t of(std::uint32_t plane, bool turned, LeafId owner) {
            if (all.empty() || all.back().plane != plane) {
                of_plane.clear();  // Cells come plane by plane.
            }
            const std::uint64_t key = std::uint64_t{owner} << 1 | (turned ? 1U : 0U);
            const auto [found, added] = of_plane.try_emplace(key, static_cast<std::uint32_t>(all.size()));
            if (added) {
                all.push_back({plane, turned, owner});
            }
            return found->second;
        }
        std::vector<Kind> all;
        std::unordered_map<std::uint64_t, std::uint32_t> of_plane;
    };

    [[nodiscard]] bool is_surface(const ComplexCell& cell) const {
        return values_.solid[cell.above] != values_.solid[cell.below];
    }
    [[nodiscard]] bool turned(const ComplexCell& cell) const { return values_.solid[cell.above] != 0; }

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
            for (j = i; j < sides.size() && sides[j].lo == sides[i].lo && sides[j].hi == sides[i].hi; ++j) {
                count += is_surface(complex_.cells[sides[j].cell]) ? 1 : 0;
            }
            for (std::size_t k = i; k < j && count > 2; ++k) {
                places.push_back(
                    {sides[k].lo, sides[k].hi, sides[k].cell, sides[k].left ? 1u : 0u, static_cast<double>(k - i) + 1});
            }
        }
        std::vector<double> result;
        if (places.empty()) {
            return result;
        }
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
                if (at != places.end() && key(*at) == key(sought)) {
                    result[3 * t + static_cast<std::size_t>(k)] = at->turn;
                }
            }
        }
        return result;
    }

    const CellComplex& complex_;
    const RegionValues& values_;
};

}  // namespace

Mesh surface(const CellComplex& complex, const RegionValues& values, std::size_t points,
             const std::function<glm::dvec3(std::uint32_t)>& place,
             const std::function<glm::dvec3(std::uint32_t)>& normal, const std::stop_token& stop) {
    return SurfaceMaker(complex, values).make(points, place, normal, stop);
}

}  // namespace csg::reference
