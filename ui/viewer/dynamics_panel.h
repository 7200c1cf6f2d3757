// Depictions of motion, labels and arrows, in the place of the drawing panel.
#pragma once

#include <string>

#include "ui/viewer/session.h"
#include "ui/viewer/theme.h"

namespace ui {

class DynamicsPanel {
  public:
    void draw(const Rectangle& place, const Session& session, const Fonts& fonts, Commands& commands);

  private:
    void depictions(const Session& session, const Fonts& fonts, GlyphTexts& texts, Commands& commands);
    void rules(const Session& session, const Fonts& fonts, GlyphTexts& texts);
    void bodies(const Session& session, GlyphTexts& texts, Commands& commands);
    void labels(const Session& session, const Fonts& fonts, GlyphTexts& texts, Commands& commands);

    std::string new_depiction_, rules_file_, label_, new_arrow_;
    int technique_ = 0;  ///< Of technique_names().
};

/// The texts as options of the command line.
[[nodiscard]] std::string options_of(const GlyphTexts& texts);

}  // namespace ui
