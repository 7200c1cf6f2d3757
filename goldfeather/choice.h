// Which engine draws a scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace goldfeather {

enum class EngineKind {
    Goldfeather,  ///< engine.h
    Lists,        ///< lists.h
    ListsCpu,     ///< lists_cpu.h
};

/// "goldfeather", "lists", "lists-cpu".
[[nodiscard]] std::string_view name(EngineKind kind);

/// What is known before a scene is drawn.
struct EngineConditions {
    bool software_renderer = false;  ///< OpenGL is computed by the CPU.
    bool over_budget = false;        ///< Some part has no sum of products.
};

struct EngineChoice {
    EngineKind engine = EngineKind::Goldfeather;
    std::string reason;  ///< For people.
};

/// `wanted`: the user's choice, where there is one. Goldfeather cannot draw a scene that is over budget; whoever wants
/// it all the same is to be told so before.
[[nodiscard]] EngineChoice choose_engine(std::optional<EngineKind> wanted, const EngineConditions& conditions);

}  // namespace goldfeather
