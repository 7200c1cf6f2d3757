// The engine of this folder for the table of engines.
#pragma once

#include "goldfeather/engine.h"

namespace goldfeather {

struct ListsEntry {
    [[nodiscard]] static EngineInfo info() {
        // Two passes, and a walk along each list.
        return {"lists", {}, [](const EngineConditions& c) { return 2 + 8 + c.walked(); }};
    }
    [[nodiscard]] static std::unique_ptr<Engine> make(const EngineSettings& settings);
};

}  // namespace goldfeather
