#include "csg/solid/prism_stack.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "csg/solid/indexed_outline.h"
#include "csg/solid/triangulate_region.h"

namespace csg::solid {
namespace {

/// Of the largest coordinate, as the grid of outlines: what is off by no more is rounding.
constexpr double kRounding = 0x1p-40;
/// Heights of one operand; the work is the square of them.
constexpr std::size_t kMostHeights = 64;

using Outlines = std::vector<std::shared_ptr<const Outline>>;

/// Sorted; of those that rounding keeps apart, the lowest.
void make_set(std::vector<double>& heights, double rounding) {
    std::sort(heights.begin(), heights.end());
    std::size_t count = 0;
    for (const double z : heights) {
        if (count == 0 || z - heights[count - 1] > rounding) {
            heights[count++] = z;
        }
    }
    heights.resize(count);
}

std::vector<double> heights_of(std::span<const PrismStack> stacks) {
    std::vector<double> heights;
    double reach = 0;
    for (const PrismStack& stack : stacks) {
        for (const Prism& prism : stack) {
            heights.push_back(prism.lo);
            heights.push_back(prism.hi);
            reach = std::max({reach, std::abs(prism.lo), std::abs(prism.hi)});
        }
    }
    make_set(heights, reach * kRounding);
    return heights;
}

void add(PrismStack& stack, Prism prism) {
    if (prism.outline->empty()) {
        return;
    }
    if (!stack.empty() && stack.back().hi == prism.lo && stack.back().outline->loops == prism.outline->loops) {
        stack.back().hi = prism.hi;
    } else {
        stack.push_back(std::move(prism));
    }
}

/// What the stack has at a height; null where that is nothing.
std::shared_ptr<const Outline> at_height(const PrismStack& stack, double z) {
    const auto at = std::find_if(stack.begin(), stack.end(), [&](const Prism& p) { return p.lo <= z && z <= p.hi; });
    return at == stack.end() ? nullptr : at->outline;
}

/// Slab by slab.
PrismStack combine_stacks(BooleanKind kind, std::span<const PrismStack> stacks) {
    PrismStack result;
    const std::vector<double> heights = heights_of(stacks);
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        Outlines operands;
        for (const PrismStack& stack : stacks) {
            const auto outline = at_height(stack, 0.5 * (heights[i] + heights[i + 1]));
            if (outline || kind != BooleanKind::Union) {
                operands.push_back(outline ? outline : std::make_shared<Outline>());
            }
        }
        if (operands.size() == 1) {
            add(result, {heights[i], heights[i + 1], operands[0]});
        } else if (!operands.empty()) {
            add(result, {heights[i], heights[i + 1], std::make_shared<Outline>(combine(kind, operands))});
        }
    }
    return result;
}

/// The mesh at its own heights, each cut just above the lower one, where corners are exact.
std::optional<PrismStack> prisms_of_solid(const Piece& piece) {
    const Solid& solid = *piece.solid;
    if (!solid.closed) {
        return {};
    }
    std::vector<glm::dvec3> points;
    double reach = 0;
    for (const glm::dvec3& p : solid.points) {
        const glm::dvec3& placed = points.emplace_back(piece.placed * glm::dvec4(p, 1.0));
        reach = std::max({reach, std::abs(placed.x), std::abs(placed.y), std::abs(placed.z)});
    }
    if (!std::isfinite(reach)) {
        return {};
    }
    const double rounding = reach * kRounding;
    std::vector<double> heights;
    heights.reserve(points.size());
    for (const glm::dvec3& p : points) {
        heights.push_back(p.z);
    }
    make_set(heights, rounding);
    const std::size_t count = heights.size();
    if (count > kMostHeights) {
        return {};
    }
    for (const glm::uvec3& t : solid.triangles) {
        const glm::dvec3 &a = points[t.x], &b = points[t.y], &c = points[t.z];
        const auto [low, high] = std::minmax({a.z, b.z, c.z});
        const glm::dvec2 u(b - a), v(c - a);
        const double longest = std::sqrt(std::max({glm::dot(u, u), glm::dot(v, v), glm::dot(v - u, v - u)}));
        if (high - low > rounding && std::abs(u.x * v.y - u.y * v.x) > rounding * longest) {
            return {};
        }
    }
    PrismStack stack;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        Piece moved = piece;
        moved.placed[3].z -= heights[i] * moved.placed[3].w;
        add(stack, {heights[i], heights[i + 1], std::make_shared<Outline>(cut(std::span(&moved, 1)))});
    }
    return stack;
}

std::optional<PrismStack> prisms_of_piece(const Piece& piece) {
    if (!piece.boolean) {
        return prisms_of_solid(piece);
    }
    check_depth(*piece.boolean);
    std::vector<PrismStack> operands;
    for (const std::vector<Piece>& operand : piece.boolean->operands) {
        std::vector<Piece> placed = operand;
        for (Piece& p : placed) {
            p.placed = piece.placed * p.placed;
        }
        auto stack = prisms_of(placed);
        if (!stack) {
            return {};
        }
        operands.push_back(std::move(*stack));
    }
    return combine_stacks(piece.boolean->kind, operands);
}

Mesh mesh_of(const Prism& prism) {
    const IndexedOutline outline = index_corners(*prism.outline);
    const auto n = static_cast<std::uint32_t>(outline.points.size());
    Mesh mesh;
    for (const double z : {prism.lo, prism.hi}) {
        for (const glm::dvec2& p : outline.points) {
            mesh.points.emplace_back(p, z);
        }
    }
    for (const glm::uvec3& t : triangulate_region(outline)) {
        mesh.triangles.emplace_back(t.x, t.z, t.y);
        mesh.triangles.push_back(t + n);
    }
    for (const std::vector<std::uint32_t>& loop : outline.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
            mesh.triangles.emplace_back(a, b, b + n);
            mesh.triangles.emplace_back(a, b + n, a + n);
        }
    }
    return mesh;
}

/// Turns the axis (x, y or z: 0, 1 or 2) into z.
glm::dmat4 to_z(int axis) {
    glm::dmat4 matrix(0.0);
    for (int i = 0; i < 3; ++i) {
        matrix[(i + axis + 1) % 3][i] = 1;
    }
    matrix[3][3] = 1;
    return matrix;
}

std::optional<std::vector<Mesh>> sum_along(std::span<const std::vector<Piece>> operands, int axis) {
    const glm::dmat4 turned = to_z(axis);
    std::optional<PrismStack> sum;
    std::vector<PrismStack> stacks;
    for (const std::vector<Piece>& operand : operands) {
        std::vector<Piece> pieces = operand;
        for (Piece& piece : pieces) {
            piece.placed = turned * piece.placed;
        }
        auto stack = prisms_of(pieces);
        if (!stack) {
            return {};
        }
        if (!stack->empty()) {
            stacks.push_back(std::move(*stack));
        }
    }
    for (const PrismStack& stack : stacks) {
        sum = sum ? minkowski(*sum, stack) : stack;
    }
    std::vector<Mesh> meshes = meshes_of(sum.value_or(PrismStack()));
    const glm::dmat3 back = glm::transpose(glm::dmat3(turned));
    for (Mesh& mesh : meshes) {
        for (glm::dvec3& p : mesh.points) {
            p = back * p;
        }
    }
    return meshes;
}

bool is_convex(const std::vector<Piece>& operand) {
    return operand.size() == 1 && operand[0].solid && operand[0].solid->convex;
}

}  // namespace

std::optional<PrismStack> prisms_of(std::span<const Piece> pieces) {
    std::vector<PrismStack> stacks;
    for (const Piece& piece : pieces) {
        auto stack = prisms_of_piece(piece);
        if (!stack) {
            return {};
        }
        stacks.push_back(std::move(*stack));
    }
    if (heights_of(stacks).size() > kMostHeights) {
        return {};
    }
    return combine_stacks(BooleanKind::Union, stacks);
}

PrismStack minkowski(const PrismStack& a, const PrismStack& b) {
    std::vector<PrismStack> sums;
    for (const Prism& p : a) {
        for (const Prism& q : b) {
            sums.push_back({{p.lo + q.lo, p.hi + q.hi, std::make_shared<Outline>(minkowski(*p.outline, *q.outline))}});
        }
    }
    return sums.size() == 1 ? sums[0] : combine_stacks(BooleanKind::Union, sums);
}

std::vector<Mesh> meshes_of(const PrismStack& stack) {
    std::vector<Mesh> meshes;
    for (const Prism& prism : stack) {
        meshes.push_back(mesh_of(prism));
    }
    return meshes;
}

std::optional<std::vector<Mesh>> minkowski_of_prisms(std::span<const std::vector<Piece>> operands) {
    if (std::all_of(operands.begin(), operands.end(), is_convex)) {
        return {};
    }
    for (const int axis : {2, 0, 1}) {
        if (auto meshes = sum_along(operands, axis)) {
            return meshes;
        }
    }
    return {};
}

}  // namespace csg::solid
