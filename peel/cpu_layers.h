// Layers in main memory, as npr/ reads them.
#pragma once

#include "goldfeather/lists_cpu/lists_cpu.h"
#include "goldfeather/surface_rows.h"

namespace peel {

using goldfeather::CpuLayer;
using goldfeather::CpuLayers;
using goldfeather::kNoSurface;
using goldfeather::LeafRow;
using goldfeather::SurfaceRows;

}  // namespace peel
