// The engine of this folder for the table of engines.
#pragma once

#include "goldfeather/engine.h"

namespace goldfeather {

struct GoldfeatherEntry {
    [[nodiscard]] static EngineInfo info() {
        // A pass an event and its resolve: rays differ in depth, and the deepest decides.
        return {"goldfeather", {.needs_products = true}, [](const EngineConditions& c) {
                    return (2 + 2 * c.walked()) * 3;
                }};
    }
    [[nodiscard]] static std::unique_ptr<Engine> make(const EngineSettings& settings);
};

}  // namespace goldfeather
