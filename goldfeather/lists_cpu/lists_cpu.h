// Per-pixel lists on the CPU: every surface of every leaf along each ray, sorted, and the expressions walked once.
// The A-buffer (Carpenter 1984) and the per-pixel lists of Barta and Kovács (2011), turned to CSG.
//
// Tiles of the picture are independent: a thread rasterises the triangles that reach its tile into lists, pixel by
// pixel, in double precision, sorts each list and walks it (pixel_walk.h). There is no normalization, so no model is
// too complex; all layers come from the one walk. No OpenGL is needed, and the same scene gives the same bytes on every
// machine, whatever the number of threads.
#pragma once

#include <cstdint>
#include <deque>
#include <glm/glm.hpp>
#include <stop_token>
#include <vector>

#include "base/camera.h"
#include "csg/solid/placed.h"
#include "csg/tree/scene.h"
#include "goldfeather/layer_stack.h"
#include "goldfeather/lists_cpu/expression_state.h"
#include "goldfeather/walk_stats.h"

namespace goldfeather {

/// A scene made ready for the lists.
struct ListsModel {
    ListsModel(const csg::Scene& s, const csg::solid::Geometry& g) : scene(s), geometry(g), expressions(s) {}
    const csg::Scene& scene;  ///< Must outlive the model, as `geometry`.
    const csg::solid::Geometry& geometry;
    ExpressionTree expressions;
};

/// One layer of a stack in main memory, in the form of LayerStack's textures. Rows from bottom to top.
struct CpuLayer {
    std::vector<float> depth;         ///< 0: no surface.
    std::vector<glm::uvec2> surface;  ///< See LayerStack::surface.
};

struct CpuLayers {
    static constexpr int kTileSide = 32;  ///< Pixels; tiles are counted row by row from the lower left.
    glm::ivec2 size{0};
    int layers = 0;  ///< At least 1; `planes` may hold more, from a picture before.
    bool complete = false;
    std::deque<CpuLayer> planes;  ///< A deque, so that those there stay where they are while it grows.
    std::vector<int> held;        ///< By tile: layers in which it holds a surface.
    std::vector<int> counts;      ///< By pixel: the same.

    /// Makes planes, empty ones, until there are `count`.
    void reserve(std::size_t count);
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

/// Fills `out` (whose memory is used again) with the first `max_layers` surfaces of the whole scene (0: all).
/// `threads`: 0 for one a core. Throws base::Stopped where `stop` asked for it; `out` can be filled again.
void peel_lists(const ListsModel& model, const base::View& view, int max_layers, unsigned threads, CpuLayers& out,
                ListsStats& stats, const std::stop_token& stop = {});

/// Leaves out the layers, from the last on, in which fewer than this share of the pixels hold a surface (Nienhaus 2005,
/// 5.2); the first one stays. What was walked is not saved, but everything that is done by layers later on.
void leave_out_sparse_layers(CpuLayers& layers, double minimal_fraction);

/// Counts a picture drawn from lists among those that a walk drew.
void add(WalkStats& walk, const ListsStats& lists);

/// The same stack as engines and tests compare it.
[[nodiscard]] HostLayers to_host(const CpuLayers& layers);

/// All of the above for one picture.
[[nodiscard]] HostLayers peel_to_host(const csg::Scene& scene, const csg::solid::Geometry& geometry,
                                      const base::View& view, int max_layers = 0, unsigned threads = 0);

}  // namespace goldfeather
