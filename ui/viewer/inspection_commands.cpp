#include "ui/viewer/inspection_commands.h"

#include <utility>

#include "ui/viewer/commands.h"

namespace ui {

// Not where it is called: GCC 12 takes what the inner variant does not hold for uninitialized there.
void ask(std::vector<Command>& commands, InspectionCommand command) {
    commands.emplace_back(std::move(command));
}

}  // namespace ui
