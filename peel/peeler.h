// Peels a scene into its stack of layers.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "goldfeather/choice.h"
#include "goldfeather/goldfeather/engine.h"
#include "goldfeather/lists/lists.h"
#include "goldfeather/lists_cpu/lists_cpu.h"
#include "goldfeather/scs/scs.h"
#include "layers/texture_stack.h"
#include "layers/upload.h"

namespace peel {

using goldfeather::EngineKind;
using goldfeather::kAllLayers;
using goldfeather::WalkStats;

/// A scene ready to be peeled from any view by one engine.
struct PeelModel {
    /// `products[i]` belongs to `scene.parts[i]`; only Goldfeather and SCS need them. Scene and geometry must outlive
    /// this.
    PeelModel(const gl::Functions& gl, const csg::Scene& scene, const csg::solid::Geometry& geometry,
              std::vector<std::vector<goldfeather::Product>> products, EngineKind engine = EngineKind::Goldfeather);

    EngineKind engine;
    goldfeather::ListsModel lists;

    std::shared_ptr<const layers::SurfaceBuffers> table;
    std::optional<goldfeather::LeafBuffers> leaves;      ///< For the engines on OpenGL, …
    std::string leaves_fault;                            ///< … or why there are none.
    std::optional<goldfeather::ListsScene> lists_scene;  ///< For `lists`, where there are leaves.
    std::vector<csg::Box> leaf_boxes;
    std::vector<char> wound, open;  ///< By LeafId: Solid::winds(); not Solid::closed.
    std::vector<std::vector<goldfeather::Product>> products;
    std::vector<csg::PartKind> kinds;
    csg::Box box;  ///< Of all leaves, world coordinates.
};

/// Peels scenes: part by part with Goldfeather or SCS, merged by depth, or all at once with per-pixel lists. Where
/// OpenGL cannot give the lists what they need, or computes them wrong, or where SCS cannot draw what is asked, lists
/// on the CPU draw, and the statistics say why.
class Peeler {
  public:
    /// `gl` must outlive the peeler.
    /// `minimal_fraction`: see goldfeather::EngineOptions.
    explicit Peeler(const gl::Functions& gl, std::size_t memory_budget = goldfeather::kDefaultMemoryBudget,
                    double minimal_fraction = 0);

    /// Throws gl::Error where a program does not compile. The first `max_layers` surfaces of the whole scene
    /// (kAllLayers: all). Where surfaces of two parts coincide, a highlighted part comes first, and otherwise the part
    /// with the smaller id.
    /// Throws base::Stopped where `stop` asked for it.
    [[nodiscard]] layers::TextureStack peel(const base::View& view, PeelModel& model, int max_layers, WalkStats& stats,
                                            const std::stop_token& stop = {});

    /// Hands a stack back that nobody reads any more: the next one may use its textures again.
    void give_back(layers::TextureStack stack) { upload_.give_back(std::move(stack)); }

  private:
    [[nodiscard]] layers::TextureStack peel_parts(const base::View& view, PeelModel& model, int max_layers,
                                                  WalkStats& stats, const std::stop_token& stop);
    [[nodiscard]] std::optional<layers::TextureStack> peel_lists(const base::View& view, PeelModel& model,
                                                                 int max_layers, WalkStats& stats,
                                                                 const std::stop_token& stop);
    [[nodiscard]] layers::TextureStack peel_lists_cpu(const base::View& view, const PeelModel& model, int max_layers,
                                                      WalkStats& stats, const std::stop_token& stop);
    [[nodiscard]] layers::TextureStack merge(const layers::TextureStack& front, const layers::TextureStack& back,
                                             int max_layers);

    const gl::Functions& gl_;
    std::size_t memory_budget_;
    double minimal_fraction_;
    std::optional<goldfeather::Goldfeather> engine_;  ///< Made when first used: its programs take time to compile.
    std::optional<goldfeather::Lists> lists_;         ///< Likewise.
    std::optional<goldfeather::Scs> scs_;             ///< Likewise.
    std::string lists_fault_;                         ///< Why there are no lists on this OpenGL.
    std::optional<gl::Program> merge_;                ///< Likewise.
    gl::VertexArray empty_array_;
    gl::Framebuffer target_;
    gl::Texture target_color_;
    layers::HostStack cpu_layers_;  ///< Its memory is used again.
    layers::Upload upload_;
};

}  // namespace peel
