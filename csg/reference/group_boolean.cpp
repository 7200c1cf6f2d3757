#include "csg/reference/group_boolean.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/stop.h"
#include "csg/reference/exact_boolean.h"
#include "csg/reference/plane_boolean.h"
#include "csg/reference/segments.h"
#include "csg/reference/self_intersection.h"
#include "csg/reference/simple_leaf.h"

namespace csg::reference {
namespace {

/// Of the diagonal: far above the rounding of coordinates, far below anything modeled on purpose.
constexpr double kCrossing = 1e-8;
/// Of the diagonal: where planes that near to each other are one, details are lost.
constexpr double kCoarse = 1e-5;

class GroupMaker {
  public:
    GroupMaker(const LeafGroups& groups, std::size_t group, const BooleanRequest& request, unsigned threads)
        : groups_(groups), group_(group), request_(request), threads_(threads) {}

    BooleanResult make() {
        if (!request_.method) {
            if (BooleanResult copy; copy_alone(copy)) {
                return copy;
            }
        }
        const CombinedLeaves leaves = groups_.combined(group_);
        BooleanResult result = combine(leaves);
        for (std::uint32_t& source : result.mesh.sources) {
            source = leaves.sources[source];
        }
        return result;
    }

  private:
    bool copy_alone(BooleanResult& result) {
        const LeafGroups::Alone alone = groups_.alone(group_);
        if (alone.leaf == nullptr) {
            return false;
        }
        auto found = simple_surface(*alone.leaf, request_.stop);
        if (!found) {
            return false;
        }
        result.mesh = std::move(found->mesh);
        result.mesh.sources.assign(result.mesh.triangles.size(), alone.source);
        result.facts = found->facts;
        result.method = Method::Copy;
        return true;
    }

    BooleanResult combine(const CombinedLeaves& leaves) {
        std::string reason;
        if (request_.method != Method::Exact) {
            try {
                return by_planes(leaves);
            } catch (const Undecided& undecided) {
                reason = undecided.what();
                if (request_.method) {
                    throw;
                }
            }
        }
        BooleanResult result = by_exact_arithmetic(leaves);
        result.reason = std::move(reason);
        return result;
    }

    /// Of the result as a whole, as far as is known.
    [[nodiscard]] double diagonal(const BooleanResult& result) const {
        const double own = result.facts.box.diagonal();
        return groups_.size() == 1 ? own : std::max(own, groups_.extent().diagonal());
    }

    void check(BooleanResult& result, Overlaps overlaps) {
        const Mesh& mesh = result.mesh;
        result.facts = facts(mesh);
        if (!result.facts.manifold) {
            throw Undecided("the surface is not closed");
        }
        if (!mesh.empty() && !(result.facts.volume > 0)) {
            throw Undecided("the surface encloses no volume");
        }
        base::end_if_asked(request_.stop);
        if (count_self_intersections(mesh, kCrossing * diagonal(result), overlaps, request_.stop) != 0) {
            throw Undecided("the surface crosses itself");
        }
    }

    BooleanResult by_planes(const CombinedLeaves& leaves) {
        BooleanResult result;
        try {
            result.mesh = plane_boolean(leaves.group, leaves.expression, threads_, request_.stop);
            check(result, Overlaps::Counted);
            const double size = result.mesh.empty() ? leaves.group.extent.diagonal() : diagonal(result);
            if (groups_.tolerance() > kCoarse * size) {
                throw Undecided("the tolerance is too coarse for a solid so small and so far from the origin");
            }
        } catch (const std::logic_error&) {  // CGAL's: its text is of no use here
            throw Undecided("the triangulation of a plane contradicts itself");
        }
        return result;
    }

    BooleanResult by_exact_arithmetic(const CombinedLeaves& leaves) {
        BooleanResult result;
        result.method = Method::Exact;
        try {
            result.mesh = exact_boolean(leaves.group, leaves.expression, threads_, request_.stop);
            check(result, Overlaps::Ignored);
        } catch (const std::logic_error&) {  // CGAL's
            throw std::runtime_error("no mesh: the arrangement of the faces contradicts itself");
        } catch (const Undecided& undecided) {
            throw std::runtime_error(fmt::format("no mesh: {}", undecided.what()));
        }
        return result;
    }

    const LeafGroups& groups_;
    std::size_t group_;
    const BooleanRequest& request_;
    unsigned threads_;
};

}  // namespace

BooleanResult group_boolean(const LeafGroups& groups, std::size_t group, const BooleanRequest& request,
                            unsigned threads) {
    return GroupMaker(groups, group, request, threads).make();
}

}  // namespace csg::reference
