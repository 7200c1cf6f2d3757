// Which engine draws a scene.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "csg/tree/box.h"
#include "goldfeather/walk_stats.h"

namespace goldfeather {

enum class EngineKind {
    Goldfeather,  ///< engine.h
    Lists,        ///< lists.h
    ListsCpu,     ///< lists_cpu.h
    Scs,          ///< scs.h
};

inline constexpr std::array kEngineKinds{EngineKind::Goldfeather, EngineKind::Lists, EngineKind::ListsCpu,
                                         EngineKind::Scs};

/// "goldfeather", "lists", "lists-cpu", "scs".
[[nodiscard]] constexpr std::string_view name(EngineKind kind) {
    constexpr std::array<std::string_view, kEngineKinds.size()> kNames{"goldfeather", "lists", "lists-cpu", "scs"};
    return kNames[static_cast<std::size_t>(kind)];
}

/// Does the engine draw sums of products?
[[nodiscard]] constexpr bool needs_products(EngineKind kind) {
    return kind == EngineKind::Goldfeather || kind == EngineKind::Scs;
}

/// What the user wants of the engines.
struct EngineOptions {
    EngineOptions(std::optional<EngineKind> wanted = {}) : kind(wanted) {}
    EngineOptions(EngineKind wanted) : kind(wanted) {}
    std::optional<EngineKind> kind;                    ///< Absent: chosen for each model.
    std::size_t memory_budget = kDefaultMemoryBudget;  ///< Bytes of per-pixel state on OpenGL at once.
    /// Layers that fewer than this share of the pixels have may be left out; 0: none. Goldfeather saves passes, and
    /// lists on the CPU what styles do with them.
    double minimal_fraction = 0;
};

/// What is known before a scene is drawn.
struct EngineConditions {
    bool software_renderer = false;  ///< OpenGL is computed by the CPU.
    bool over_budget = false;        ///< Some part has no sum of products.
    double depth = 0;                ///< Surfaces of leaves that a ray through the scene meets, about.
    int layers = kAllLayers;         ///< Wanted: the first so many.
};

struct EngineChoice {
    EngineKind engine = EngineKind::Goldfeather;
    std::string reason;  ///< For people.
};

/// About how many surfaces of leaves a ray through the scene meets: the areas of the leaves' boxes over that of the
/// scene's, twice (a ray enters a convex leaf once and leaves it once).
[[nodiscard]] double estimated_depth(std::span<const csg::Box> leaf_boxes, const csg::Box& scene);

/// The estimated cost of a picture of the layers wanted, as a multiple of drawing all leaves once with a GPU, or with
/// the CPU where that computes OpenGL. Infinite where the engine cannot draw the scene. docs/PERFORMANCE.md, "Choice".
[[nodiscard]] double estimated_cost(EngineKind kind, const EngineConditions& conditions);

/// The engine with the least estimated cost, or the user's choice (`wanted`). Goldfeather cannot draw a scene that is
/// over budget; whoever wants it all the same is to be told so before.
[[nodiscard]] EngineChoice choose_engine(std::optional<EngineKind> wanted, const EngineConditions& conditions);

}  // namespace goldfeather
