#include "goldfeather/engines.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "base/alternatives.h"
#include "goldfeather/engine_table.h"

namespace goldfeather {
namespace {

template <typename... Entries>
std::array<EngineInfo, sizeof...(Entries)> infos(std::type_identity<std::tuple<Entries...>> /*table*/) {
    return {Entries::info()...};
}

}  // namespace

std::span<const EngineInfo> engines() {
    static const auto all = infos(std::type_identity<EngineTable>());
    return all;
}

const EngineInfo* find_engine(std::string_view name) {
    const auto all = engines();
    const auto found = std::find_if(all.begin(), all.end(), [&](const EngineInfo& e) { return e.name == name; });
    return found == all.end() ? nullptr : &*found;
}

const EngineInfo& fallback_engine() {
    return *find_engine(ListsCpuEntry::info().name);
}

std::string engine_names() {
    std::vector<std::string> names;
    for (const EngineInfo& engine : engines()) {
        names.emplace_back(engine.name);
    }
    return base::alternatives(names);
}

}  // namespace goldfeather
