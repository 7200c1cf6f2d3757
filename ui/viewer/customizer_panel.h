// The customizer: a control for each parameter of the main file, group by group, and its parameter sets.
#pragma once

#include <string>

#include "ui/viewer/commands.h"
#include "ui/viewer/customizer.h"
#include "ui/viewer/layout.h"
#include "ui/viewer/theme.h"

namespace ui {

/// Keeps what was typed. To be drawn between ImGui::NewFrame and ImGui::Render.
class CustomizerPanel {
  public:
    /// Adds to `commands` what the user asks for.
    void draw(const Rectangle& place, const Customizer& customizer, const Fonts& fonts, Commands& commands);

  private:
    void sets(const Customizer& customizer, Commands& commands);

    std::string name_;   ///< Of the set to be saved.
    std::string shown_;  ///< The set that was used when it was proposed.
    bool sure_ = false;  ///< Delete was pressed once.
};

/// A control for the parameter, as wide as there is room; gives true and the new value where the user has changed it.
bool draw_customized(const csg::scad::CustomizerParameter& parameter, csg::scad::CustomizerParameter::Value& value);

/// The nearest number on the parameter's steps, within its limits.
[[nodiscard]] double on_step(const csg::scad::CustomizerParameter& parameter, double number);

}  // namespace ui
