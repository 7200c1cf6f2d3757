#include "goldfeather/choice.h"

namespace goldfeather {

std::string_view name(EngineKind kind) {
    switch (kind) {
        case EngineKind::Goldfeather:
            return "goldfeather";
        case EngineKind::Lists:
            return "lists";
        case EngineKind::ListsCpu:
            return "lists-cpu";
    }
    return "";
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
