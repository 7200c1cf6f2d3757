#include "csg/reference/flat_areas.h"

#include <optional>
#include <utility>

#include "base/stop.h"
#include "csg/reference/area_outlines.h"
#include "csg/reference/face_planes.h"
#include "csg/reference/plane_cells.h"
#include "csg/solid/used_points.h"

namespace csg::reference {
namespace {

class AreaMerger {
  public:
    AreaMerger(const Mesh& mesh, std::span<const glm::dvec3> normals, const std::stop_token& stop)
        : mesh_(mesh), normals_(normals), stop_(stop), outlines_(mesh) {}

    /// The mesh with its areas filled anew; nothing where all stays as it is.
    std::optional<Mesh> merge() {
        if (!outlines_.closed()) {
            return std::nullopt;
        }
        frozen_.assign(outlines_.areas(), 0);
        // What cannot be filled keeps its points, and its neighbors keep theirs beside it.
        constexpr int kAttempts = 4;
        for (int attempt = 0; attempt < kAttempts; ++attempt) {
            outlines_.straighten(frozen_);
            if (!outlines_.any_lost()) {
                return std::nullopt;
            }
            if (!fill()) {
                continue;
            }
            if (Mesh result = assembled(); freeze_shared_edges(result)) {
                return result;
            }
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] std::uint32_t kind(std::uint32_t area) const { return mesh_.sources[outlines_.first_triangle(area)]; }

    /// False where an area could not be filled, and is frozen.
    bool fill() {
        bool all = true;
        filled_.assign(outlines_.areas(), {});
        for (std::uint32_t area = 0; area < outlines_.areas(); ++area) {
            base::end_if_asked(stop_);
            if (outlines_.lost_of(area).empty()) {
                continue;
            }
            try {
                filled_[area] = fill_area(outlines_.border_of_lost(area), mesh_.points, normals_[kind(area)]);
            } catch (const Undecided&) {
                frozen_[area] = 1;
                all = false;
            }
        }
        return all;
    }

    /// What is filled stands in place of the first triangle that it replaces. Its points are still those of the old
    /// mesh.
    [[nodiscard]] Mesh assembled() {
        Mesh result;
        area_of_.clear();
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            const std::uint32_t area = outlines_.area_of(t);
            if (!outlines_.lost(t)) {
                add(result, mesh_.triangles[t], area);
            } else if (t == outlines_.lost_of(area)[0]) {
                for (const glm::uvec3& triangle : filled_[area]) {
                    add(result, triangle, area);
                }
            }
        }
        return result;
    }
    void add(Mesh& result, const glm::uvec3& triangle, std::uint32_t area) {
        result.triangles.push_back(triangle);
        result.sources.push_back(kind(area));
        area_of_.push_back(area);
    }

    /// Sheets that touch along an edge may have been told apart by points on it alone. True where no such edge is left;
    /// then the points are numbered anew.
    bool freeze_shared_edges(Mesh& result) {
        const std::vector<std::uint32_t> twins = twins_of(result.triangles);
        bool good = true;
        for (std::uint32_t e = 0; e < twins.size(); ++e) {
            if (twins[e] == kNoTwin) {
                frozen_[area_of_[e / 3]] = 1;
                good = false;
            }
        }
        if (good) {
            result.points = solid::used_points(mesh_.points, result.triangles);
        }
        return good;
    }

    const Mesh& mesh_;
    std::span<const glm::dvec3> normals_;
    const std::stop_token& stop_;
    AreaOutlines outlines_;
    std::vector<char> frozen_;                     ///< By area.
    std::vector<std::vector<glm::uvec3>> filled_;  ///< By area: in place of what has lost points.
    std::vector<std::uint32_t> area_of_;           ///< By triangle of the result.
};

}  // namespace

void merge_flat_areas(Mesh& mesh, std::span<const glm::dvec3> normals, const std::stop_token& stop) {
    if (auto merged = AreaMerger(mesh, normals, stop).merge()) {
        mesh = std::move(*merged);
    }
}

}  // namespace csg::reference
