// The one list of engines.
#pragma once

#include <tuple>

#include "goldfeather/goldfeather/goldfeather_engine.h"
#include "goldfeather/lists/lists_engine.h"
#include "goldfeather/lists_cpu/lists_cpu_engine.h"
#include "goldfeather/scs/scs_engine.h"

namespace goldfeather {

/// In the order in which they are listed everywhere.
using EngineTable = std::tuple<GoldfeatherEntry, ListsEntry, ListsCpuEntry, ScsEntry>;

}  // namespace goldfeather
