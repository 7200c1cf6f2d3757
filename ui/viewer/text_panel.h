// The text of the model, with the place that was asked for. That of the main file can be edited in it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "ui/viewer/commands.h"
#include "ui/viewer/layout.h"
#include "ui/viewer/session.h"
#include "ui/viewer/text_caret.h"
#include "ui/viewer/theme.h"

namespace ui {

/// To be drawn between ImGui::NewFrame and ImGui::Render; keeps where it has scrolled to, and its cursor.
class TextPanel {
  public:
    /// Adds to `commands` what the user asks for. Where it has the keyboard, ImGui's WantTextInput is set.
    void draw(const Rectangle& place, const Session& session, const Fonts& fonts, Commands& commands);

    /// What is typed goes to the text.
    [[nodiscard]] bool focused() const { return focused_; }
    void leave() { focused_ = false; }
    /// The key does something here, and is no shortcut for that.
    [[nodiscard]] static bool uses(const Chord& chord);

  private:
    void renew(const Session& session);
    void draw_header(const Session& session, const Fonts& fonts, Commands& commands) const;
    void draw_lines(const Session& session, Commands& commands);
    void draw_line(std::size_t line, float left, float top, float gutter) const;
    void draw_message(std::size_t line, float left, float top) const;
    void point(float left, float top, float row, Commands& commands);
    /// Takes what is typed; true where that has changed the text or moved the cursor.
    bool type(int page);
    bool press_motions(int page);
    bool press_edits();
    [[nodiscard]] std::size_t line_of(std::size_t byte) const;
    /// Without its end.
    [[nodiscard]] std::string_view line(std::size_t number) const;
    [[nodiscard]] std::size_t byte_at(std::size_t line, float x) const;

    TextPlace scrolled_to_;
    std::string text_, kinds_;                                          ///< As it is shown, and highlighted().
    std::string name_;                                                  ///< Of its file.
    std::vector<std::size_t> starts_;                                   ///< Of the lines.
    std::map<std::size_t, std::pair<LineKind, std::string>> messages_;  ///< By line, from 0.
    bool editable_ = false, focused_ = false, drags_ = false;
    bool follows_ = false;  ///< The cursor is to be seen.
    TextCaret caret_;
    std::size_t steps_ = 0;  ///< Of the document, when it was seen last.
    double moved_at_ = 0;    ///< When the cursor has moved, for its blinking.
};

}  // namespace ui
