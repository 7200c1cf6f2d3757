// All engines.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "goldfeather/engine.h"

namespace goldfeather {

/// In the order in which they are listed everywhere. The first is the default of values that are not set.
[[nodiscard]] std::span<const EngineInfo> engines();

/// Null where there is no engine of that name.
[[nodiscard]] const EngineInfo* find_engine(std::string_view name);

/// `engine`: of engines().
[[nodiscard]] std::unique_ptr<Engine> make_engine(const EngineInfo& engine, const EngineSettings& settings);

/// The one that draws everything and needs nothing: lists-cpu.
[[nodiscard]] const EngineInfo& fallback_engine();

/// "goldfeather, lists, lists-cpu or scs".
[[nodiscard]] std::string engine_names();

}  // namespace goldfeather
