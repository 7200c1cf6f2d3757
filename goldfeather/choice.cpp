#include "goldfeather/choice.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace goldfeather {

double estimated_depth(std::span<const csg::Box> leaf_boxes, const csg::Box& scene) {
    const auto area = [](const csg::Box& box) {
        const glm::dvec3 size = box.empty() ? glm::dvec3(0.0) : box.size();
        return size.x * size.y + size.y * size.z + size.z * size.x;
    };
    double sum = 0;
    for (const csg::Box& box : leaf_boxes) {
        sum += area(box);
    }
    const double whole = area(scene);
    return whole > 0 ? 2 * sum / whole : 0;
}

double estimated_cost(const EngineInfo& engine, const EngineConditions& conditions) {
    const bool impossible = engine.cost == nullptr || (engine.capabilities.needs_products && conditions.over_budget);
    return impossible ? std::numeric_limits<double>::infinity() : engine.cost(conditions);
}

EngineChoice choose_engine(const EngineInfo* wanted, const EngineConditions& conditions) {
    if (wanted != nullptr) {
        return {wanted, "as asked for"};
    }
    EngineChoice choice{
        &fallback_engine(),
        fmt::format("OpenGL is computed by {}; estimated for {}:", conditions.software_renderer ? "the CPU" : "a GPU",
                    conditions.layers == kAllLayers ? "all layers"
                    : conditions.layers == 1        ? "one layer"
                                                    : fmt::format("{} layers", conditions.layers))};
    double least = std::numeric_limits<double>::infinity();
    // The last of the table need the least: at equal cost they are chosen.
    const std::span<const EngineInfo> all = engines();
    for (auto engine = all.rbegin(); engine != all.rend(); ++engine) {
        if (engine->cost == nullptr) {
            continue;
        }
        const double cost = estimated_cost(*engine, conditions);
        choice.reason += std::isinf(cost) ? fmt::format(" {}: too many products;", engine->name)
                                          : fmt::format(" {} {:.1f},", engine->name, cost);
        if (cost < least) {
            least = cost;
            choice.engine = &*engine;
        }
    }
    choice.reason.pop_back();
    choice.reason += " draws of all leaves";
    return choice;
}

}  // namespace goldfeather
