#include "goldfeather/smooth_facets.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/parallel.h"
#include "csg/solid/corner_normals.h"
#include "goldfeather/local_frame.h"

namespace goldfeather {
namespace {

using csg::solid::CornerNormals;

constexpr double kSameNormal = 1 - 1e-9;  // Cosine.

/// In 16 bits each, the coordinates of an octahedron; 0 for none.
std::uint32_t packed(const glm::dvec3& n) {
    const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    if (sum == 0) {
        return 0;
    }
    glm::dvec2 at = glm::dvec2(n) / sum;
    if (n.z < 0) {
        at = (1.0 - glm::abs(glm::dvec2(at.y, at.x))) * glm::dvec2(at.x < 0 ? -1 : 1, at.y < 0 ? -1 : 1);
    }
    const glm::uvec2 bits(glm::round(at * 32767.0) + 32768.0);
    return bits.x | bits.y << 16U;
}

/// How much of the corner opposite to the side from `a` to `b` there is at a point.
glm::vec4 share(const glm::dvec3& across, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 gradient = glm::cross(across, b - a) / glm::dot(across, across);
    return {glm::vec3(gradient), static_cast<float>(-glm::dot(gradient, a))};
}

struct FacetRow {
    std::uint32_t plane;
    layers::SmoothFacet facet;
};

std::vector<FacetRow> rows_of(const csg::solid::PlacedLeaf& leaf, std::uint32_t number, const glm::dvec3& center) {
    const std::vector<CornerNormals> normals = csg::solid::corner_normals(leaf);
    std::vector<FacetRow> rows;
    for (std::size_t t = 0; t < normals.size(); ++t) {
        const glm::uvec3& corners = leaf.triangles[t];
        const glm::dvec3 a = leaf.points[corners.x] - center, b = leaf.points[corners.y] - center,
                         c = leaf.points[corners.z] - center;
        const glm::dvec3 across = glm::cross(b - a, c - a);
        const double area = glm::length(across);
        const bool flat = std::all_of(normals[t].begin(), normals[t].end(),
                                      [&](const glm::dvec3& n) { return glm::dot(n, across) >= kSameNormal * area; });
        const bool none =
            std::all_of(normals[t].begin(), normals[t].end(), [](const glm::dvec3& n) { return n == glm::dvec3(0); });
        if (area > 0 && !flat && !none) {
            rows.push_back({leaf.planes[t].index,
                            {share(across, b, c),
                             share(across, c, a),
                             {packed(normals[t][0]), packed(normals[t][1]), packed(normals[t][2]), number}}});
        }
    }
    return rows;
}

layers::SmoothFacets by_plane(const std::vector<std::vector<FacetRow>>& by_leaf, std::size_t planes) {
    layers::SmoothFacets smooth;
    smooth.starts.assign(planes + 1, 0);
    for (const std::vector<FacetRow>& rows : by_leaf) {
        for (const FacetRow& row : rows) {
            ++smooth.starts[row.plane + 1];
        }
    }
    for (std::size_t plane = 1; plane < smooth.starts.size(); ++plane) {
        smooth.starts[plane] += smooth.starts[plane - 1];
    }
    smooth.facets.resize(smooth.starts.back());
    std::vector<std::uint32_t> next(smooth.starts.begin(), smooth.starts.end() - 1);
    for (const std::vector<FacetRow>& rows : by_leaf) {
        for (const FacetRow& row : rows) {
            smooth.facets[next[row.plane]++] = row.facet;
        }
    }
    return smooth;
}

void find_rows(const csg::solid::Geometry& geometry, const std::vector<csg::LeafId>& leaves,
               std::vector<std::vector<FacetRow>>& by_leaf) {
    const glm::dvec3 center = local_frame(geometry).center;
    base::for_each_index(static_cast<int>(leaves.size()), [&] {
        return [&](int i) {
            const csg::LeafId leaf = leaves[static_cast<std::size_t>(i)];
            by_leaf[leaf] = rows_of(geometry.leaves[leaf], leaf, center);
        };
    });
}

std::vector<csg::LeafId> all_leaves(const csg::solid::Geometry& geometry) {
    std::vector<csg::LeafId> all(geometry.leaves.size());
    std::iota(all.begin(), all.end(), csg::LeafId{0});
    return all;
}

}  // namespace

layers::SmoothFacets smooth_facets(const csg::solid::Geometry& geometry) {
    std::vector<std::vector<FacetRow>> by_leaf(geometry.leaves.size());
    find_rows(geometry, all_leaves(geometry), by_leaf);
    return by_plane(by_leaf, geometry.planes.planes().size());
}

struct SmoothFacetKeeper::Rows {
    std::vector<std::vector<FacetRow>> by_leaf;  ///< Empty: not known.
    std::vector<csg::LeafId> changed;
};

SmoothFacetKeeper::SmoothFacetKeeper() : rows_(std::make_unique<Rows>()) {}
SmoothFacetKeeper::~SmoothFacetKeeper() = default;

void SmoothFacetKeeper::forget() {
    *rows_ = {};
}

void SmoothFacetKeeper::changed(const csg::solid::SceneChange& change) {
    if (change.structure || change.center || change.all_planes) {
        forget();
        return;
    }
    rows_->changed.insert(rows_->changed.end(), change.leaves.begin(), change.leaves.end());
}

layers::SmoothFacets SmoothFacetKeeper::facets(const csg::solid::Geometry& geometry) {
    if (rows_->by_leaf.size() != geometry.leaves.size()) {
        rows_->by_leaf.resize(geometry.leaves.size());
        rows_->changed = all_leaves(geometry);
    }
    std::sort(rows_->changed.begin(), rows_->changed.end());
    rows_->changed.erase(std::unique(rows_->changed.begin(), rows_->changed.end()), rows_->changed.end());
    find_rows(geometry, rows_->changed, rows_->by_leaf);
    rows_->changed.clear();
    return by_plane(rows_->by_leaf, geometry.planes.planes().size());
}

}  // namespace goldfeather
