#include "ui/pipeline/motion/tracks.h"

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

#include "csg/tree/hash.h"
#include "ui/pipeline/motion/leaf_paths.h"

namespace ui {

std::uint32_t Tracks::placement_id(const glm::dmat4& matrix) {
    std::uint64_t hash = 0;
    for (int i = 0; i < 4; ++i) {
        hash = csg::mix(hash, glm::dvec3(matrix[i]));
    }
    const auto [first, last] = placement_ids_.equal_range(hash);
    for (auto at = first; at != last; ++at) {
        if (placements_[at->second] == matrix) {
            return at->second;
        }
    }
    const auto id = static_cast<std::uint32_t>(placements_.size());
    placements_.push_back(matrix);
    placement_ids_.emplace(hash, id);
    return id;
}

TrackSample Tracks::add(double time, std::shared_ptr<const csg::Tree> tree) {
    csg::Scene scene = csg::make_scene(*tree);
    const std::vector<LeafPath> paths = leaf_paths(*tree, scene);
    std::map<std::uint64_t, std::vector<csg::LeafId>> groups;
    for (csg::LeafId leaf = 0; leaf < paths.size(); ++leaf) {
        groups[paths[leaf].calls].push_back(leaf);
    }
    std::vector<std::uint32_t> track_of(paths.size(), kAbsent);
    std::vector<csg::LeafId> added;
    for (const auto& [calls, leaves] : groups) {
        std::vector<Known>& known = by_calls_[calls];
        std::unordered_map<std::uint64_t, std::deque<std::size_t>> of_shape;
        for (std::size_t k = 0; k < known.size(); ++k) {
            of_shape[known[k].shape].push_back(k);
        }
        std::vector<char> taken(known.size(), 0);
        const auto take = [&](std::size_t k, csg::LeafId leaf) {
            taken[k] = 1;
            known[k].shape = paths[leaf].shape;
            track_of[leaf] = known[k].track;
        };
        for (const csg::LeafId leaf : leaves) {
            if (auto& alike = of_shape[paths[leaf].shape]; !alike.empty()) {
                take(alike.front(), leaf);
                alike.pop_front();
            }
        }
        std::size_t next = 0;
        for (const csg::LeafId leaf : leaves) {
            while (next < known.size() && taken[next] != 0) {
                ++next;
            }
            if (track_of[leaf] == kAbsent && next < known.size()) {
                take(next, leaf);
            }
        }
        for (const csg::LeafId leaf : leaves) {
            if (track_of[leaf] == kAbsent) {
                added.push_back(leaf);
            }
        }
    }
    std::sort(added.begin(), added.end());
    for (const csg::LeafId leaf : added) {
        track_of[leaf] = static_cast<std::uint32_t>(tracks_.size());
        by_calls_[paths[leaf].calls].push_back({track_of[leaf], paths[leaf].shape});
        tracks_.push_back({runs_.size(), leaf});
    }
    TrackSample sample{time, std::vector(tracks_.size(), kAbsent), std::vector<std::uint64_t>(tracks_.size(), 0)};
    for (csg::LeafId leaf = 0; leaf < paths.size(); ++leaf) {
        sample.placements[track_of[leaf]] = placement_id(scene.leaves[leaf].to_world);
        sample.shapes[track_of[leaf]] = paths[leaf].shape;
    }
    if (!added.empty()) {
        runs_.push_back({std::move(tree), std::move(scene), std::move(track_of)});
    }
    return sample;
}

}  // namespace ui
