#include "csg/reference/cell_complex.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <random>

namespace csg::reference {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

class UnionFind {
  public:
    explicit UnionFind(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void unite(std::uint32_t a, std::uint32_t b) { parent_[std::max(find(a), find(b))] = std::min(find(a), find(b)); }

  private:
    std::vector<std::uint32_t> parent_;
};

/// Where a ray meets leaves, in double precision: rays that pass an edge closely are refused.
class RayProbe {
  public:
    RayProbe(const solid::Geometry& geometry, std::span<const LeafId> leaves) : geometry_(geometry), leaves_(leaves) {}

    /// Sets the bits of the leaves that hold the points just beyond `origin` in `direction`, faces on plane `without`
    /// not counted (the origin is on it). False where the ray is too near to an edge to tell.
    bool holders(const glm::dvec3& origin, const glm::dvec3& direction, std::uint32_t without,
                 std::span<std::uint64_t> bits) const {
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            const solid::PlacedLeaf& leaf = geometry_.leaves[leaves_[i]];
            if (!meets(leaf.box, origin, direction))
                continue;
            bool odd = false;
            for (std::size_t t = 0; t < leaf.triangles.size(); ++t) {
                if (leaf.planes[t].index == without)
                    continue;
                const int hit = crosses(leaf, leaf.triangles[t], origin, direction);
                if (hit < 0)
                    return false;
                odd ^= hit == 1;
            }
            if (odd)
                bits[i / 64] |= std::uint64_t{1} << (i % 64);
        }
        return true;
    }

  private:
    static bool meets(const Box& box, const glm::dvec3& origin, const glm::dvec3& direction) {
        double from = 0, to = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            const double margin = 1e-6 * (box.hi[axis] - box.lo[axis]);
            const double a = (box.lo[axis] - margin - origin[axis]) / direction[axis];
            const double b = (box.hi[axis] + margin - origin[axis]) / direction[axis];
            from = std::max(from, std::min(a, b));
            to = std::min(to, std::max(a, b));
        }
        return from <= to;
    }

    /// 1: yes, 0: no, -1: cannot be told.
    static int crosses(const solid::PlacedLeaf& leaf, const glm::uvec3& t, const glm::dvec3& o, const glm::dvec3& d) {
        const glm::dvec3 a = leaf.points[t.x] - o, b = leaf.points[t.y] - o, c = leaf.points[t.z] - o;
        const glm::dvec3 bc = glm::cross(b, c), ca = glm::cross(c, a), ab = glm::cross(a, b);
        const double u = glm::dot(d, bc), v = glm::dot(d, ca), w = glm::dot(d, ab);
        // Relative to the sizes that cancel in each of them.
        const double scale = 1e-11 * std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)});
        if ((u > scale && v < -scale) || (v > scale && w < -scale) || (w > scale && u < -scale) ||
            (u < -scale && v > scale) || (v < -scale && w > scale) || (w < -scale && u > scale))
            return 0;
        const double volume = glm::dot(a, bc);
        if (std::abs(u) <= scale || std::abs(v) <= scale || std::abs(w) <= scale) {
            // Beside an edge; behind the origin it does not matter.
            return volume * (u + v + w) < 0 && std::abs(volume) > scale * 1e-3 ? 0 : -1;
        }
        return (volume > 0) == (u + v + w > 0) ? 1 : 0;
    }

    const solid::Geometry& geometry_;
    std::span<const LeafId> leaves_;
};

class Builder {
  public:
    Builder(const solid::Geometry& geometry, std::span<const LeafId> leaves, const PointTable& points)
        : geometry_(geometry), leaves_(leaves), points_(points) {}

    CellComplex build(std::vector<PlaneCells> planes) {
        take_cells(std::move(planes));
        sort_sides();
        UnionFind sides(2 * complex_.cells.size()), pieces(complex_.cells.size());
        for (std::size_t i = 0, j; i < sides_.size(); i = j) {
            for (j = i + 1; j < sides_.size() && sides_[j].lo == sides_[i].lo && sides_[j].hi == sides_[i].hi; ++j)
                pieces.unite(sides_[i].cell, sides_[j].cell);
            for (std::size_t k = i; k < j; ++k) {
                const Side &s = sides_[k], &next = sides_[k + 1 < j ? k + 1 : i];
                sides.unite(2 * s.cell + (s.left ? 0u : 1u), 2 * next.cell + (next.left ? 1u : 0u));
            }
        }
        number_regions(sides);
        find_holders(pieces);
        return std::move(complex_);
    }

  private:
    struct Side {
        std::uint32_t lo, hi, cell;
        bool left;
        double angle;
    };

    void take_cells(std::vector<PlaneCells> planes) {
        for (std::uint32_t p = 0; p < planes.size(); ++p) {
            const auto first = static_cast<std::uint32_t>(complex_.cells.size());
            for (PlaneCells::Cell& cell : planes[p].cells)
                complex_.cells.push_back({p, std::move(cell.leaves), std::move(cell.triangles), 0, 0});
            for (const PlaneCells::Side& s : planes[p].sides)
                sides_.push_back({s.lo, s.hi, first + s.cell, s.left, 0});
        }
    }

    /// By edge, and around each edge counter-clockwise seen against lo → hi.
    void sort_sides() {
        for (Side& s : sides_) {
            const glm::dvec3 along = points_[s.hi] - points_[s.lo];
            const glm::dvec3 a = glm::abs(along);
            const glm::dvec3 helper = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                                      : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                               : glm::dvec3(0, 0, 1);
            const glm::dvec3 x = glm::normalize(glm::cross(along, helper));
            const glm::dvec3 y = glm::normalize(glm::cross(along, x));
            const glm::dvec3 normal = geometry_.planes.planes()[complex_.cells[s.cell].plane].normal;
            const glm::dvec3 into = glm::cross(normal, along) * (s.left ? 1.0 : -1.0);
            s.angle = std::atan2(glm::dot(into, y), glm::dot(into, x));
        }
        std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
            return std::tie(a.lo, a.hi, a.angle, a.cell) < std::tie(b.lo, b.hi, b.angle, b.cell);
        });
        for (std::size_t i = 0; i + 1 < sides_.size(); ++i) {
            const Side &a = sides_[i], &b = sides_[i + 1];
            if (a.lo == b.lo && a.hi == b.hi && b.angle - a.angle < 1e-9)
                throw Undecided("two faces meet at an edge at no angle");
        }
    }

    void number_regions(UnionFind& sides) {
        std::vector<std::uint32_t> number(2 * complex_.cells.size(), kNone);
        const auto region = [&](std::uint32_t side) {
            std::uint32_t& n = number[sides.find(side)];
            if (n == kNone)
                n = static_cast<std::uint32_t>(complex_.regions++);
            return n;
        };
        for (std::uint32_t c = 0; c < complex_.cells.size(); ++c) {
            complex_.cells[c].above = region(2 * c);
            complex_.cells[c].below = region(2 * c + 1);
        }
    }

    std::span<std::uint64_t> bits(std::uint32_t region) {
        return std::span(complex_.inside).subspan(region * complex_.words, complex_.words);
    }

    void find_holders(UnionFind& pieces) {
        complex_.words = (leaves_.size() + 63) / 64;
        complex_.inside.assign(complex_.regions * complex_.words, 0);
        index_.assign(geometry_.leaves.size(), 0);
        for (std::uint32_t i = 0; i < leaves_.size(); ++i)
            index_[leaves_[i]] = i;
        std::vector<std::vector<std::uint32_t>> cells_at(complex_.regions);
        for (std::uint32_t c = 0; c < complex_.cells.size(); ++c) {
            cells_at[complex_.cells[c].above].push_back(c);
            cells_at[complex_.cells[c].below].push_back(c);
        }
        std::vector<char> known(complex_.regions, 0);
        for (std::uint32_t c = 0; c < complex_.cells.size(); ++c) {
            if (pieces.find(c) != c)
                continue;
            const std::uint32_t seed = complex_.cells[c].above;
            probe(complex_.cells[c], bits(seed));
            known[seed] = 1;
            std::deque<std::uint32_t> waiting{seed};
            while (!waiting.empty()) {
                const std::uint32_t region = waiting.front();
                waiting.pop_front();
                for (const std::uint32_t at : cells_at[region])
                    step(complex_.cells[at], region, known, waiting);
            }
        }
        // Every cell must lead from its one side to the other, whichever way its regions were reached.
        for (const ComplexCell& cell : complex_.cells) {
            std::vector<std::uint64_t> expected = crossed(cell, cell.above);
            const auto actual = bits(cell.below);
            if (!std::equal(expected.begin(), expected.end(), actual.begin(), actual.end()))
                throw Undecided("the regions between the faces do not fit together");
        }
    }

    std::vector<std::uint64_t> crossed(const ComplexCell& cell, std::uint32_t from) {
        const auto before = bits(from);
        std::vector<std::uint64_t> after(before.begin(), before.end());
        for (const LeafId leaf : cell.leaves)
            after[index_[leaf] / 64] ^= std::uint64_t{1} << (index_[leaf] % 64);
        return after;
    }

    void step(const ComplexCell& cell, std::uint32_t from, std::vector<char>& known,
              std::deque<std::uint32_t>& waiting) {
        const std::uint32_t to = cell.above == from ? cell.below : cell.above;
        if (known[to] != 0)
            return;
        known[to] = 1;
        const std::vector<std::uint64_t> after = crossed(cell, from);
        std::copy(after.begin(), after.end(), bits(to).begin());
        waiting.push_back(to);
    }

    void probe(const ComplexCell& cell, std::span<std::uint64_t> into) const {
        const auto area = [&](const glm::uvec3& t) {
            return glm::length(glm::cross(points_[t.y] - points_[t.x], points_[t.z] - points_[t.x]));
        };
        const glm::uvec3 t = *std::max_element(cell.triangles.begin(), cell.triangles.end(),
                                               [&](const auto& a, const auto& b) { return area(a) < area(b); });
        const glm::dvec3 normal = geometry_.planes.planes()[cell.plane].normal;
        const RayProbe ray(geometry_, leaves_);
        std::mt19937 random(1);
        const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
        for (int attempt = 0; attempt < 64; ++attempt) {
            const double u = 0.2 + 0.3 * number(), v = 0.2 + 0.3 * number();
            const glm::dvec3 origin = points_[t.x] * (1 - u - v) + points_[t.y] * u + points_[t.z] * v;
            const glm::dvec3 aside{number() - 0.5, number() - 0.5, number() - 0.5};
            std::fill(into.begin(), into.end(), 0);
            if (ray.holders(origin, glm::normalize(normal + aside), cell.plane, into))
                return;
        }
        throw Undecided("no ray from a face tells what is in front of it");
    }

    const solid::Geometry& geometry_;
    std::span<const LeafId> leaves_;
    const PointTable& points_;
    CellComplex complex_;
    std::vector<Side> sides_;
    std::vector<std::uint32_t> index_;  ///< By leaf: its bit.
};

}  // namespace

CellComplex make_complex(const solid::Geometry& geometry, std::span<const LeafId> leaves, const PointTable& points,
                         std::vector<PlaneCells> cells) {
    return Builder(geometry, leaves, points).build(std::move(cells));
}

}  // namespace csg::reference
