// Which engine draws a scene.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "csg/tree/box.h"
#include "goldfeather/engines.h"

namespace goldfeather {

/// What the user wants of the engines.
struct EngineOptions {
    EngineOptions(const EngineInfo* wanted = nullptr) : engine(wanted) {}
    const EngineInfo* engine;                          ///< Null: chosen for each model.
    std::size_t memory_budget = kDefaultMemoryBudget;  ///< See EngineSettings.
    /// Layers that fewer than this share of the pixels have may be left out; 0: none. Goldfeather saves passes, and
    /// lists on the CPU what styles do with them.
    double minimal_fraction = 0;
};

struct EngineChoice {
    const EngineInfo* engine = &engines().front();
    std::string reason{};  ///< For people.
};

/// About how many surfaces of leaves a ray through the scene meets: the areas of the leaves' boxes over that of the
/// scene's, twice (a ray enters a convex leaf once and leaves it once).
[[nodiscard]] double estimated_depth(std::span<const csg::Box> leaf_boxes, const csg::Box& scene);

/// The estimated cost of a picture of the layers wanted, as a multiple of drawing all leaves once with a GPU, or with
/// the CPU where that computes OpenGL. Infinite where the engine cannot draw the scene. docs/PERFORMANCE.md, "Choice".
[[nodiscard]] double estimated_cost(const EngineInfo& engine, const EngineConditions& conditions);

/// The engine with the least estimated cost, or the user's choice (`wanted`, not null). Goldfeather cannot draw a scene
/// that is over budget; whoever wants it all the same is to be told so before.
[[nodiscard]] EngineChoice choose_engine(const EngineInfo* wanted, const EngineConditions& conditions);

}  // namespace goldfeather
