// All actions of the window, found by typing some of their letters.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/viewer/commands.h"
#include "ui/viewer/keys.h"

namespace ui {

/// How well the letters of `typed` are found in `text`, in their order, capital or not: the more, the better; nothing
/// where they are not. Letters that follow each other, and those that words begin with, count more.
[[nodiscard]] std::optional<int> fuzzy_score(std::string_view typed, std::string_view text);

/// All actions but those that make no sense there, "Add › Cube", the best first; of equal ones as menus have them.
struct PaletteEntry {
    Action action;
    std::string name;
};
[[nodiscard]] std::vector<PaletteEntry> palette_entries(std::string_view typed);

/// To be drawn between ImGui::NewFrame and ImGui::Render; keeps what was typed as long as it is open.
class PaletteForm {
  public:
    void draw(const Keys& keys, Commands& commands);

  private:
    void rows(const Keys& keys, bool take, Commands& commands);

    std::string typed_;
    std::vector<PaletteEntry> entries_;
    std::size_t chosen_ = 0;
    bool scrolls_ = false;  ///< The one that is chosen is to be seen.
};

}  // namespace ui
