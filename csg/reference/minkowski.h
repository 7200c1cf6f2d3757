// Minkowski sums.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "csg/reference/mesh.h"

namespace csg::reference {

/// The Minkowski sum of solids, each the union of closed meshes, as one closed mesh; all sources are 0. Where only one
/// operand is not empty, it is the sum, united.
///
/// No operand is decomposed. Let P be convex sets within A that cover its surface (its faces do), and Q such sets for
/// B. The boundary of A + B is within ∂A + ∂B, so the union U of all hulls of p + q reaches it everywhere; and what is
/// not in U is, hole by hole, wholly inside A + B or wholly outside, which one point of each tells. Throws
/// std::runtime_error where a mesh is not closed, and where so many hulls are needed that memory would not do;
/// base::Stopped where `stop` asked for it.
[[nodiscard]] Mesh minkowski_sum(std::span<const std::vector<Mesh>> operands, const std::stop_token& stop = {});
[[nodiscard]] Mesh minkowski_sum(std::span<const Mesh> operands, const std::stop_token& stop = {});

}  // namespace csg::reference
