#include "ui/viewer/tools.h"

#include <array>

#include "ui/viewer/tools/fly_tool.h"
#include "ui/viewer/tools/measure_tool.h"
#include "ui/viewer/tools/move_tool.h"
#include "ui/viewer/tools/scale_tool.h"
#include "ui/viewer/tools/section_tool.h"
#include "ui/viewer/tools/select_tool.h"
#include "ui/viewer/tools/size_tool.h"
#include "ui/viewer/tools/turn_tool.h"
#include "ui/viewer/tools/view_cube.h"

namespace ui {

std::span<const ToolInfo> tools() {
    static constexpr std::array kTools{
        ToolInfo{"cube", {}, "", make_view_cube},
        ToolInfo{"section", {}, "", make_section_tool},
        ToolInfo{"select", Action::SelectTool, "", make_select_tool},
        ToolInfo{
            "move", Action::MoveTool,
            "Move: drag an arrow, a square or the middle of what is selected; Ctrl on the grid, Shift in line with "
            "others, or type how far",
            make_move_tool},
        ToolInfo{"turn", Action::TurnTool,
                 "Turn: drag a ring of what is selected; in whole degrees, with Ctrl in steps of 15, or type how many",
                 make_turn_tool},
        ToolInfo{
            "size", Action::SizeTool,
            "Size: drag a dimension of the cube, sphere or cylinder that is selected; Ctrl on the grid, or type it",
            make_size_tool},
        ToolInfo{"scale", Action::ScaleTool,
                 "Scale: drag the end of an axis of what is selected, or its middle; Ctrl in steps of 0.25, or type it",
                 make_scale_tool},
        ToolInfo{"measure", Action::MeasureTool,
                 "Measure: click a corner, an edge or a face, and another; Ctrl+C copies, Esc begins anew",
                 make_measure_tool},
        ToolInfo{"fly", Action::FlyTool,
                 "Fly: W A S D forward and sideways, E Q up and down, Shift quicker, drag to look around, Esc ends it",
                 make_fly_tool},
    };
    return kTools;
}

}  // namespace ui
