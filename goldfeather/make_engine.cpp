// Apart from the other functions of engines.h: what needs names only links no engine.
#include <array>
#include <type_traits>

#include "goldfeather/engine_table.h"
#include "goldfeather/engines.h"

namespace goldfeather {
namespace {

using Make = std::unique_ptr<Engine> (*)(const EngineSettings& settings);

template <typename... Entries>
std::array<Make, sizeof...(Entries)> makers(std::type_identity<std::tuple<Entries...>> /*table*/) {
    return {Entries::make...};
}

}  // namespace

std::unique_ptr<Engine> make_engine(const EngineInfo& engine, const EngineSettings& settings) {
    static const auto all = makers(std::type_identity<EngineTable>());
    return all[static_cast<std::size_t>(&engine - engines().data())](settings);
}

}  // namespace goldfeather
