// The text of the model, with the place that was asked for.
#pragma once

#include <string>

#include "ui/viewer/commands.h"
#include "ui/viewer/layout.h"
#include "ui/viewer/theme.h"

namespace ui {

/// To be drawn between ImGui::NewFrame and ImGui::Render; keeps where it has scrolled to.
class TextPanel {
  public:
    /// `shown`: its text may be null. Adds to `commands` what the user asks for.
    void draw(const Rectangle& place, const TextPlace& shown, const Fonts& fonts, Commands& commands);

  private:
    TextPlace scrolled_to_;
};

}  // namespace ui
