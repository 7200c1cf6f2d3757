// The engine of this folder for the table of engines.
#pragma once

#include "goldfeather/engine.h"

namespace goldfeather {

struct ListsCpuEntry {
    [[nodiscard]] static EngineInfo info() {
        // Measured on a software renderer, where drawing the leaves once and a core's own work are in one currency.
        // With a GPU only the numbers of passes are known; drawing is taken to cost it a thirtieth of what it costs the
        // CPU.
        constexpr double kCpuPerGpu = 30;
        return {"lists-cpu", {.needs_opengl = false}, [](const EngineConditions& c) {
                    return (1.5 + 0.1 * c.walked()) * (c.software_renderer ? 1 : kCpuPerGpu);
                }};
    }
    [[nodiscard]] static std::unique_ptr<Engine> make(const EngineSettings& settings);
};

}  // namespace goldfeather
