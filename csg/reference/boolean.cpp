#include "csg/reference/boolean.h"

#include <algorithm>
#include <atomic>

#include "base/stop.h"
#include "base/threads.h"
#include "csg/reference/group_boolean.h"
#include "csg/reference/open_leaves.h"

namespace csg::reference {
namespace {

/// Products of four coordinates are numbers.
constexpr double kLargest = 1e75;
/// Groups of together about so many triangles are the work of one thread; what is larger is shared by all.
constexpr std::size_t kTrianglesPerTask = 8192;

/// Groups one after another.
struct Task {
    std::size_t first, end;
    bool large;
};

std::vector<Task> tasks_of(const LeafGroups& groups) {
    std::vector<Task> tasks;
    std::size_t triangles = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const std::size_t own = groups.triangles(g);
        const bool large = own > kTrianglesPerTask;
        if (large || triangles + own > kTrianglesPerTask || tasks.empty() || tasks.back().large) {
            tasks.push_back({g, g, large});
            triangles = 0;
        }
        tasks.back().end = g + 1;
        triangles += own;
    }
    return tasks;
}

/// Appends a mesh that shares nothing with the one so far.
void append(BooleanResult& all, BooleanResult&& more) {
    const auto first = static_cast<std::uint32_t>(all.mesh.points.size());
    all.mesh.points.insert(all.mesh.points.end(), more.mesh.points.begin(), more.mesh.points.end());
    for (const glm::uvec3& t : more.mesh.triangles) {
        all.mesh.triangles.push_back(t + first);
    }
    all.mesh.sources.insert(all.mesh.sources.end(), more.mesh.sources.begin(), more.mesh.sources.end());
    all.facts = both(all.facts, more.facts);
    all.method = std::max(all.method, more.method);
    if (all.reason.empty()) {
        all.reason = std::move(more.reason);
    }
}

class GroupsMesh {
  public:
    GroupsMesh(const LeafGroups& groups, const BooleanRequest& request)
        : groups_(groups), request_(request), tasks_(tasks_of(groups)), results_(tasks_.size()) {}

    /// Tasks are independent of each other; the result does not depend on the number of threads.
    BooleanResult make() {
        std::atomic<std::size_t> next{0};
        const auto work = [&] {
            for (std::size_t i; (i = next.fetch_add(1)) < tasks_.size();) {
                if (!tasks_[i].large) {
                    run(i, 1);
                }
            }
        };
        for (std::size_t i = 0; i < tasks_.size(); ++i) {
            if (tasks_[i].large) {
                run(i, request_.threads);
            }
        }
        base::on_threads(request_.threads, static_cast<unsigned>(std::min<std::size_t>(tasks_.size(), 1024)), work,
                         [&] { next = tasks_.size(); });
        if (results_.size() == 1) {
            return std::move(results_[0]);
        }
        return joined();
    }

  private:
    void run(std::size_t task, unsigned threads) {
        BooleanResult& result = results_[task];
        result.method = Method::Copy;
        result.facts.manifold = true;
        for (std::size_t g = tasks_[task].first; g < tasks_[task].end; ++g) {
            base::end_if_asked(request_.stop);
            BooleanResult own = group_boolean(groups_, g, request_, threads);
            if (tasks_[task].end - tasks_[task].first == 1) {
                result = std::move(own);
            } else {
                append(result, std::move(own));
            }
        }
    }

    BooleanResult joined() {
        BooleanResult all;
        std::size_t points = 0, triangles = 0;
        for (const BooleanResult& r : results_) {
            points += r.mesh.points.size();
            triangles += r.mesh.triangles.size();
        }
        all.mesh.points.reserve(points);
        all.mesh.triangles.reserve(triangles);
        all.mesh.sources.reserve(triangles);
        all.method = groups_.size() == 0 ? Method::Planes : Method::Copy;
        all.facts.manifold = true;
        for (BooleanResult& r : results_) {
            base::end_if_asked(request_.stop);
            append(all, std::move(r));
            r = {};
        }
        return all;
    }

    const LeafGroups& groups_;
    const BooleanRequest& request_;
    std::vector<Task> tasks_;
    std::vector<BooleanResult> results_;  ///< By task.
};

/// The leaves of the solid parts that have triangles, sorted.
std::vector<LeafId> leaves_of(const Scene& scene, const solid::Geometry& geometry) {
    std::vector<LeafId> leaves;
    for (const PartId part : solid_parts(scene)) {
        const Part& p = scene.parts[part];
        for (LeafId leaf = p.first_leaf; leaf < p.first_leaf + p.leaf_count; ++leaf) {
            if (!geometry.leaves[leaf].triangles.empty()) {
                leaves.push_back(leaf);
            }
        }
    }
    std::sort(leaves.begin(), leaves.end());
    return leaves;
}

BooleanResult of_closed_leaves(const Scene& scene, const solid::Geometry& geometry, std::span<const LeafId> leaves,
                               const BooleanRequest& request) {
    const LeafGroups groups(scene, geometry, leaves, request.stop);
    return GroupsMesh(groups, request).make();
}

}  // namespace

const char* name(Method method) {
    switch (method) {
        case Method::Copy:
            return "copy";
        case Method::Planes:
            return "planes";
        case Method::Exact:
            return "exact";
    }
    return "";
}

BooleanResult make_mesh(const Scene& scene, const solid::Geometry& geometry, const BooleanRequest& request) {
    std::vector<LeafId> leaves = leaves_of(scene, geometry);
    for (const LeafId leaf : leaves) {
        const Box& box = geometry.leaves[leaf].box;
        const glm::dvec3 most = glm::max(glm::abs(box.lo), glm::abs(box.hi));
        if (!(std::max({most.x, most.y, most.z}) <= kLargest)) {
            throw LeafError(leaf, "it reaches farther than 1e75 from the origin, too far for a mesh");
        }
    }
    const std::vector<LeafId> open = open_leaves(geometry, leaves);
    if (open.empty()) {
        return of_closed_leaves(scene, geometry, leaves, request);
    }
    if (const auto combined = find_combined(scene, geometry, leaves, open)) {
        throw LeafError(*combined,
                        "its surface is open, so that nothing tells what is inside: it cannot be combined with "
                        "other objects");
    }
    std::erase_if(leaves, [&](LeafId leaf) { return std::binary_search(open.begin(), open.end(), leaf); });
    BooleanResult result = of_closed_leaves(scene, geometry, leaves, request);
    for (const LeafId leaf : open) {
        append_leaf(result.mesh, geometry.leaves[leaf], leaf);
    }
    result.facts = facts(result.mesh);
    return result;
}

}  // namespace csg::reference
