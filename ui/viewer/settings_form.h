// The form for what the user has chosen for all runs: mouse, theme, size of the text, keys.
#pragma once

#include <optional>

#include "ui/viewer/commands.h"
#include "ui/viewer/settings.h"
#include "ui/viewer/theme.h"

namespace ui {

class SettingsForm {
  public:
    void draw(const Settings& settings, const Fonts& fonts, Commands& commands);

    /// The next key is to be that action's.
    [[nodiscard]] const std::optional<Action>& learns() const { return learns_; }
    /// The key that was waited for was pressed, or is not waited for any more.
    void stop_learning() { learns_.reset(); }

  private:
    void look(const Settings& settings, Commands& commands);
    void keys(const Keys& keys, const Fonts& fonts, Commands& commands);

    std::optional<Action> learns_;
};

}  // namespace ui
