#include "csg/reference/collapse.h"

#include <algorithm>
#include <iterator>

#include "csg/solid/used_points.h"

namespace csg::reference {
namespace {

class Collapser {
  public:
    explicit Collapser(Mesh& mesh) : mesh_(mesh), at_(mesh.points.size()), gone_(mesh.triangles.size(), 0) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            for (int k = 0; k < 3; ++k) {
                at_[mesh.triangles[t][k]].push_back(t);
            }
        }
    }

    void run() {
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            for (bool again = true; again && gone_[t] == 0;) {
                again = false;
                for (int k = 0; k < 3 && !again; ++k) {
                    const std::uint32_t a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
                    again = mesh_.points[a] == mesh_.points[b] && collapse(std::min(a, b), std::max(a, b));
                }
            }
        }
        drop_unused();
    }

  private:
    [[nodiscard]] std::vector<std::uint32_t> neighbors(std::uint32_t point) const {
        std::vector<std::uint32_t> found;
        for (const std::uint32_t t : at_[point]) {
            for (int k = 0; k < 3; ++k) {
                if (mesh_.triangles[t][k] != point) {
                    found.push_back(mesh_.triangles[t][k]);
                }
            }
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    /// The ends must have just the two corners opposite the edge as neighbors in common (the link condition), and the
    /// piece must be more than a tetrahedron.
    bool collapse(std::uint32_t kept, std::uint32_t point) {
        const std::vector<std::uint32_t> a = neighbors(kept), b = neighbors(point);
        std::vector<std::uint32_t> both;
        std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
        if (both.size() != 2 || (a.size() == 3 && b.size() == 3)) {
            return false;
        }
        for (const std::uint32_t t : at_[point]) {
            glm::uvec3& corners = mesh_.triangles[t];
            if (corners.x == kept || corners.y == kept || corners.z == kept) {
                gone_[t] = 1;
                continue;
            }
            for (int k = 0; k < 3; ++k) {
                if (corners[k] == point) {
                    corners[k] = kept;
                }
            }
            at_[kept].push_back(t);
        }
        at_[point].clear();
        for (const std::uint32_t p : {kept, both[0], both[1]}) {
            std::erase_if(at_[p], [&](std::uint32_t t) { return gone_[t] != 0; });
        }
        return true;
    }

    void drop_unused() {
        std::size_t count = 0;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            if (gone_[t] == 0) {
                mesh_.triangles[count] = mesh_.triangles[t];
                mesh_.sources[count++] = mesh_.sources[t];
            }
        }
        mesh_.triangles.resize(count);
        mesh_.sources.resize(count);
        mesh_.points = solid::used_points(mesh_.points, mesh_.triangles);
    }

    Mesh& mesh_;
    std::vector<std::vector<std::uint32_t>> at_;  ///< Triangles, by point.
    std::vector<char> gone_;                      ///< By triangle.
};

}  // namespace

void collapse_empty_edges(Mesh& mesh) {
    Collapser(mesh).run();
}

}  // namespace csg::reference
