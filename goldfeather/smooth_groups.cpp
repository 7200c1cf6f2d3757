#include "goldfeather/smooth_groups.h"

#include <algorithm>
#include <tuple>

namespace goldfeather {
namespace {

constexpr std::uint32_t kListOfGroups = 0x80000000U, kUnknown = 0xffffffffU;

/// A plane that several leaves have, or one in several surfaces.
struct GroupRow {
    std::uint32_t plane, leaf, group;
    [[nodiscard]] auto key() const { return std::tuple(plane, leaf, group & 0xffffffU); }
};

/// Calls visit(plane, leaf, group) for all triangles.
template <typename Visit>
void for_each_triangle(const csg::solid::Geometry& geometry, const Visit& visit) {
    for (std::uint32_t l = 0; l < geometry.leaves.size(); ++l) {
        const csg::solid::PlacedLeaf& leaf = geometry.leaves[l];
        const std::span<const csg::solid::FacetGroup> groups = csg::solid::groups_of(leaf);
        for (std::size_t t = 0; t < leaf.planes.size(); ++t) {
            const std::uint32_t plane = leaf.planes[t].index;
            visit(plane, l, groups.empty() ? csg::solid::FacetGroup(plane).bits() : groups[t].bits());
        }
    }
}

}  // namespace

std::vector<std::uint32_t> smooth_groups(const csg::solid::Geometry& geometry) {
    const std::size_t planes = geometry.planes.planes().size();
    std::vector<std::uint32_t> words(planes, kUnknown), leaf_of(planes);
    for_each_triangle(geometry, [&](std::uint32_t plane, std::uint32_t leaf, std::uint32_t group) {
        std::uint32_t& word = words[plane];
        if (word == kUnknown) {
            word = group;
            leaf_of[plane] = leaf;
        } else if (word != kListOfGroups && (leaf_of[plane] != leaf || ((word ^ group) & 0xffffffU) != 0)) {
            word = kListOfGroups;
        }
    });
    std::vector<GroupRow> rows;
    GroupRow last{kUnknown, kUnknown, kUnknown};
    for_each_triangle(geometry, [&](std::uint32_t plane, std::uint32_t leaf, std::uint32_t group) {
        const GroupRow row{plane, leaf, group};
        if (words[plane] == kListOfGroups && row.key() != last.key()) {
            rows.push_back(row);
            last = row;
        }
    });
    std::sort(rows.begin(), rows.end(), [](const GroupRow& a, const GroupRow& b) { return a.key() < b.key(); });
    rows.erase(
        std::unique(rows.begin(), rows.end(), [](const GroupRow& a, const GroupRow& b) { return a.key() == b.key(); }),
        rows.end());
    for (auto row = rows.begin(); row != rows.end();) {
        const auto end = std::find_if(row, rows.end(), [&](const GroupRow& r) { return r.plane != row->plane; });
        words[row->plane] = kListOfGroups | static_cast<std::uint32_t>(words.size());
        words.push_back(static_cast<std::uint32_t>(end - row));
        for (; row != end; ++row) {
            words.push_back(row->leaf);
            words.push_back(row->group);
        }
    }
    std::replace(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(planes), kUnknown, 0U);
    return words;
}

}  // namespace goldfeather
