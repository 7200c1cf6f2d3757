// Draws with any engine, and with another one where that cannot.
#pragma once

#include <map>
#include <memory>

#include "goldfeather/engines.h"

namespace goldfeather {

/// The engines of one context, made when they are first used.
class EngineSet {
  public:
    explicit EngineSet(const EngineSettings& settings) : settings_(settings) {}

    /// Makes a scene ready for the engine. Where that meets an obstacle, lists-cpu draws, and WalkStats::fallback says
    /// why. The set must outlive the scene.
    [[nodiscard]] std::unique_ptr<PreparedScene> prepare(const EngineInput& input, const EngineInfo& meant) {
        return prepare(input, engine(meant));
    }
    /// The same with an engine that is not one of the set's. It must outlive the scene, too.
    [[nodiscard]] std::unique_ptr<PreparedScene> prepare(const EngineInput& input, Engine& meant);

  private:
    Engine& engine(const EngineInfo& info);

    EngineSettings settings_;
    std::map<std::string_view, std::unique_ptr<Engine>> made_;
};

}  // namespace goldfeather
