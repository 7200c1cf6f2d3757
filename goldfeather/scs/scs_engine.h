// The engine of this folder for the table of engines.
#pragma once

#include "goldfeather/engine.h"

namespace goldfeather {

struct ScsEntry {
    [[nodiscard]] static EngineInfo info() {
        // Not all scenes, and one layer only: never chosen.
        return {"scs", {.most_layers = 1, .needs_products = true}};
    }
    [[nodiscard]] static std::unique_ptr<Engine> make(const EngineSettings& settings);
};

}  // namespace goldfeather
