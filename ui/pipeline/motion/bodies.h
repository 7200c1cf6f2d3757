// Tracks that move as one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ui/pipeline/motion/motion.h"
#include "ui/pipeline/motion/tracks.h"

namespace ui {

/// How a track is placed against where it was at first.
class TrackMotion {
  public:
    /// `samples` by time.
    TrackMotion(const Tracks& tracks, std::uint32_t track, std::span<const TrackSample> samples);

    /// None where it is not there; where it has no volume at first, its motion is none.
    [[nodiscard]] std::optional<glm::dmat4> in(const TrackSample& sample) const;

  private:
    const Tracks& tracks_;
    std::uint32_t track_;
    std::uint32_t first_ = kAbsent;  ///< Its placement at first.
    glm::dmat4 inverse_{1.0};
};

struct Bodies {
    std::vector<MovingBody> bodies;     ///< Poses have no derivatives, and there are no events.
    std::vector<std::uint32_t> tracks;  ///< Of each body one.
    std::size_t still = 0;              ///< Tracks that never move or change.
};

/// What is known of a track's shape, in the world, when it was first there.
struct TrackShape {
    csg::Box box;
    std::vector<glm::dvec3> extremes;  ///< Its points that reach farthest along each of extreme_directions().
};
[[nodiscard]] const std::vector<glm::dvec3>& extreme_directions();

/// Of each subtree whose leaves all move alike, and that is in none such, a body. `samples` by time; `shapes` by track.
[[nodiscard]] Bodies bodies_of(const Tracks& tracks, std::span<const TrackSample> samples,
                               std::span<const TrackShape> shapes);

}  // namespace ui
