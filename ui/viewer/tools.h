// The list of the tools. A new one is a file in ui/viewer/tools and a line here; one that is taken in hand has an
// action of its own, with its keys, in commands.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "ui/viewer/commands.h"

namespace ui {

class Tool;

struct ToolInfo {
    const char* name;  ///< One word.
    /// Takes it in hand; nothing: it lies at hand always, in the picture, and sees input before the others.
    std::optional<Action> action;
    const char* hint;  ///< What it does, while it is in hand.
    std::unique_ptr<Tool> (*make)();
};

/// In the order in which they see input. The first with an action is in hand when the window opens, and after Esc.
[[nodiscard]] std::span<const ToolInfo> tools();

}  // namespace ui
