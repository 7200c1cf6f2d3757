// What every engine is to those that draw with it. Each is a folder, and a line in engine_table.h.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string_view>
#include <vector>

#include "base/camera.h"
#include "csg/solid/placed.h"
#include "csg/solid/scene_change.h"
#include "csg/tree/scene.h"
#include "goldfeather/products.h"
#include "goldfeather/walk_stats.h"
#include "layers/stack.h"

namespace gl {
struct Functions;
}

namespace goldfeather {

/// What is drawn. All of it must outlive what is made of it.
struct EngineInput {
    const csg::Scene& scene;
    const csg::solid::Geometry& geometry;
    /// By part; an empty part has none. Only engines that need products look at them.
    std::span<const std::vector<Product>> products{};
};

struct EngineCapabilities {
    int most_layers = kAllLayers;  ///< It finds the first so many.
    bool needs_opengl = true;      ///< Its stacks are in textures then, and in main memory otherwise.
    bool needs_products = false;   ///< Sums of products of all parts.
};

/// The engine cannot draw what is asked of it, and another may. what() tells why.
class EngineObstacle : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A scene made ready for an engine, which must outlive it.
class PreparedScene {
  public:
    virtual ~PreparedScene() = default;
    PreparedScene(const PreparedScene&) = delete;
    PreparedScene& operator=(const PreparedScene&) = delete;

    /// The first `max_layers` surfaces of the whole scene (kAllLayers: all), without a table. Where surfaces of two
    /// parts coincide they come in the order of parts (part_order.h). What it cost is added to `stats`. Throws
    /// EngineObstacle, gl::Error where OpenGL fails, and base::Stopped where `stop` asked for it. The memory of a stack
    /// that nobody holds any more is used again.
    [[nodiscard]] virtual layers::Stack draw(const base::View& view, int max_layers, WalkStats& stats,
                                             const std::stop_token& stop = {}) = 0;

    /// The scene has been edited in place: makes good what was made of it, with what was. False where it must be
    /// prepared anew, as it is here by default.
    [[nodiscard]] virtual bool update(const csg::solid::SceneChange& /*change*/) { return false; }

  protected:
    PreparedScene() = default;
};

struct EngineSettings {
    const gl::Functions* gl = nullptr;                 ///< Null where there is no OpenGL; must outlive the engine.
    std::size_t memory_budget = kDefaultMemoryBudget;  ///< Bytes of per-pixel state on OpenGL at once.
    /// Layers that fewer than this share of the pixels have may be left out; 0: none.
    double minimal_fraction = 0;
    unsigned threads = 0;  ///< On the CPU; 0: one a core.
};

/// Holds what is made once a context, such as programs, which are compiled when they are first used.
class Engine {
  public:
    virtual ~Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Throws EngineObstacle, and gl::Error where OpenGL fails.
    [[nodiscard]] virtual std::unique_ptr<PreparedScene> prepare(const EngineInput& input) = 0;

  protected:
    Engine() = default;
};

/// What is known before a scene is drawn.
struct EngineConditions {
    bool software_renderer = false;  ///< OpenGL is computed by the CPU.
    bool over_budget = false;        ///< Some part has no sum of products.
    double depth = 0;                ///< Surfaces of leaves that a ray through the scene meets, about.
    int layers = kAllLayers;         ///< Wanted: the first so many.

    /// Surfaces looked at until the layers are found: walks end there, and most of what a ray meets is behind the first
    /// two surfaces of a layer.
    [[nodiscard]] double walked() const { return layers == kAllLayers ? depth : std::min(depth, 2.0 * layers); }
};

/// What is known of an engine without making it.
struct EngineInfo {
    std::string_view name;  ///< For the command line.
    EngineCapabilities capabilities;
    /// The estimated cost of a picture, as a multiple of drawing all leaves once (docs/PERFORMANCE.md, "Choice"). Null
    /// where the engine is never chosen but by the user.
    double (*cost)(const EngineConditions& conditions) = nullptr;
};

}  // namespace goldfeather
