#include "goldfeather/choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

double estimated_cost(EngineKind kind, const EngineConditions& c) {
    // Measured on a software renderer, where drawing the leaves once and a core's own work are in one currency. With a
    // GPU only the numbers of passes are known; drawing is taken to cost it a thirtieth of what it costs the CPU.
    constexpr double kCpuPerGpu = 30;
    const double never = std::numeric_limits<double>::infinity();
    // Surfaces looked at until the layers are found: walks end there, and most of what a ray meets is behind the first
    // two surfaces of a layer.
    const double walked = c.layers == kAllLayers ? c.depth : std::min(c.depth, 2.0 * c.layers);
    switch (kind) {
        case EngineKind::ListsCpu:
            return (1.5 + 0.1 * walked) * (c.software_renderer ? 1 : kCpuPerGpu);
        case EngineKind::Lists:
            return 2 + 8 + walked;  // Two passes, and a walk along each list.
        case EngineKind::Goldfeather:
            // A pass an event and its resolve: rays differ in depth, and the deepest decides.
            return c.over_budget ? never : (2 + 2 * walked) * 3;
        case EngineKind::Scs:
            return never;  // Not all scenes, and one layer only: never chosen.
    }
    return never;
}

EngineChoice choose_engine(std::optional<EngineKind> wanted, const EngineConditions& conditions) {
    if (wanted) {
        return {*wanted, "as asked for"};
    }
    constexpr std::array kKinds{EngineKind::ListsCpu, EngineKind::Lists, EngineKind::Goldfeather};
    const EngineKind least = *std::min_element(kKinds.begin(), kKinds.end(), [&](EngineKind a, EngineKind b) {
        return estimated_cost(a, conditions) < estimated_cost(b, conditions);
    });
    std::string reason =
        fmt::format("OpenGL is computed by {}; estimated for {}:", conditions.software_renderer ? "the CPU" : "a GPU",
                    conditions.layers == kAllLayers ? "all layers"
                    : conditions.layers == 1        ? "one layer"
                                                    : fmt::format("{} layers", conditions.layers));
    for (const EngineKind kind : kKinds) {
        reason += kind == EngineKind::Goldfeather && conditions.over_budget
                      ? fmt::format(" {}: too many products;", name(kind))
                      : fmt::format(" {} {:.1f},", name(kind), estimated_cost(kind, conditions));
    }
    reason.pop_back();
    return {least, reason + " draws of all leaves"};
}

}  // namespace goldfeather
