// Per-pixel lists on the CPU: every surface of every leaf along each ray, sorted, and the expressions walked once.
// The A-buffer (Carpenter 1984) and the per-pixel lists of Barta and Kovács (2011), turned to CSG.
//
// Tiles of the picture are independent: a thread rasterizes the triangles that reach its tile into lists, pixel by
// pixel, in double precision, sorts each list and walks it (pixel_walk.h). There is no normalization, so no model is
// too complex; all layers come from the one walk. No OpenGL is needed, and the same scene gives the same bytes on every
// machine, whatever the number of threads.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <stop_token>
#include <vector>

#include "base/camera.h"
#include "csg/solid/placed.h"
#include "csg/solid/scene_change.h"
#include "csg/tree/scene.h"
#include "goldfeather/lists_cpu/expression_state.h"
#include "goldfeather/walk_stats.h"
#include "layers/host_stack.h"

namespace goldfeather {

/// A scene made ready for the lists.
struct ListsModel {
    ListsModel(const csg::Scene& s, const csg::solid::Geometry& g) : scene(s), geometry(g), expressions(s) {}
    const csg::Scene& scene;  ///< Must outlive the model, as `geometry`.
    const csg::solid::Geometry& geometry;
    ExpressionTree expressions;
};

struct ListsStats {
    std::uint64_t fragments = 0;
    std::uint32_t triangles = 0;                         ///< That may cover a sample.
    std::uint64_t skipped_triangles = 0;                 ///< Of drawn leaves: these cover none.
    std::uint32_t drawn_leaves = 0, skipped_leaves = 0;  ///< Skipped are those outside the view.
    std::uint32_t occluded_leaves = 0;                   ///< Of drawn leaves: no surface found is of them.
    std::uint32_t longest_list = 0;
    int layers = 0;  ///< The most of any pixel, as far as it was asked for.
};

/// Fills `out`, all but its table (its memory is used again), with the first `max_layers` surfaces of the whole scene
/// (0: all). `threads`: 0 for one a core. Throws base::Stopped where `stop` asked for it; `out` can be filled again.
void peel_lists(const ListsModel& model, const base::View& view, int max_layers, unsigned threads,
                layers::HostStack& out, ListsStats& stats, const std::stop_token& stop = {});

/// What is kept of a picture of a scene that is edited, so that the next one from there is drawn anew only where leaves
/// have moved: a cutter under a hand among thousands touches a few tiles.
class KeptLists {
  public:
    KeptLists();
    ~KeptLists();
    KeptLists(const KeptLists&) = delete;
    KeptLists& operator=(const KeptLists&) = delete;

    /// The scene has been edited, not its structure.
    void changed(const csg::solid::SceneChange& change);
    /// Nothing is known of the stack that was filled last.
    void forget();
    /// peel_lists(): the same to the last bit. `out` holds what this filled last, unless forget() was called.
    void peel(const ListsModel& model, const base::View& view, int max_layers, unsigned threads, layers::HostStack& out,
              ListsStats& stats, const std::stop_token& stop);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Counts a picture drawn from lists among those that a walk drew.
void add(WalkStats& walk, const ListsStats& lists);

/// All of the above for one picture.
[[nodiscard]] layers::HostStack peel_to_host(const csg::Scene& scene, const csg::solid::Geometry& geometry,
                                             const base::View& view, int max_layers = 0, unsigned threads = 0);

}  // namespace goldfeather
