// Leaves through the runs of a program: which leaf of one run is which of another.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <unordered_map>
#include <vector>

#include "csg/tree/scene.h"

namespace ui {

inline constexpr std::uint32_t kAbsent = ~std::uint32_t{0};

/// One run: which placement and shape each track has in it; kAbsent where it has no leaf.
struct TrackSample {
    double time = 0;
    std::vector<std::uint32_t>
        placements;                     ///< By track; into Tracks::placement(). Shorter where later tracks are none.
    std::vector<std::uint64_t> shapes;  ///< By track: a hash.
};

/// A leaf, wherever it is.
struct Track {
    std::size_t first_run = 0;  ///< Into Tracks::runs(): where it was seen first, …
    csg::LeafId leaf = 0;       ///< … as which leaf.
};

class Tracks {
  public:
    /// A run in which new tracks began.
    struct Run {
        std::shared_ptr<const csg::Tree> tree;
        csg::Scene scene;
        std::vector<std::uint32_t> track_of;  ///< By leaf.
    };

    /// Finds the leaves of the tree among the tracks by the calls that made them: those with the shape they had first,
    /// then the others in their order; what is left over begins a track.
    [[nodiscard]] TrackSample add(double time, std::shared_ptr<const csg::Tree> tree);

    [[nodiscard]] const std::vector<Track>& all() const { return tracks_; }
    [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }
    [[nodiscard]] const glm::dmat4& placement(std::uint32_t id) const { return placements_[id]; }

  private:
    struct Known {
        std::uint32_t track;
        std::uint64_t shape;  ///< When it was seen last.
    };
    std::uint32_t placement_id(const glm::dmat4& matrix);

    std::vector<Track> tracks_;
    std::vector<Run> runs_;
    std::unordered_map<std::uint64_t, std::vector<Known>> by_calls_;
    std::vector<glm::dmat4> placements_;
    std::unordered_multimap<std::uint64_t, std::uint32_t> placement_ids_;
};

}  // namespace ui
