#include "goldfeather/choice.h"

namespace goldfeather {

std::string_view name(EngineKind kind) {
    return kind == EngineKind::Goldfeather ? "goldfeather" : "lists-cpu";
}

EngineChoice choose_engine(std::optional<EngineKind> wanted, const EngineConditions& conditions) {
    if (wanted) {
        return {*wanted, "as asked for"};
    }
    if (conditions.over_budget) {
        return {EngineKind::ListsCpu, "a part has too many products"};
    }
    if (conditions.software_renderer) {
        return {EngineKind::ListsCpu, "OpenGL is computed by the CPU"};
    }
    return {EngineKind::Goldfeather, "OpenGL is computed by a GPU"};
}

}  // namespace goldfeather
