// What tools have in common that hold what is selected and put it elsewhere: the life of a drag.
#pragma once

#include <optional>
#include <string>

#include "ui/viewer/tool.h"

namespace ui {

/// press() takes hold, follow() says where it is held by now, and letting go, or Enter, puts it there.
class HoldingTool : public Tool {
  public:
    void drag(ToolContext& context, const glm::dvec2& at) override;
    void release(ToolContext& context, const glm::dvec2& at) override;
    void click(ToolContext& context, const glm::dvec2& at) override;
    bool key(ToolContext& context, const KeyEvent& event) override;
    bool cancel(ToolContext& context) override;
    /// How far it is by now, and what is typed: "X 12.5   12._".
    [[nodiscard]] std::string text() const override;

  protected:
    /// Of what is selected; a drag that begins while the text is being followed is nobody's.
    void hold(const ToolContext& context, const glm::dvec2& at);
    [[nodiscard]] bool holds() const { return held_.has_value(); }
    [[nodiscard]] csg::OccurrenceId held_occurrence() const { return held_->occurrence; }
    [[nodiscard]] const std::string& typed() const { return typed_; }
    void draw_words(const ToolPainter& painter) const;

  private:
    /// The pointer has moved there; held(), words() then say what has come of it, and of what is typed.
    virtual void follow(const ToolContext& context, const glm::dvec2& at) = 0;
    [[nodiscard]] virtual HeldPart held() const = 0;
    [[nodiscard]] virtual std::string words() const = 0;
    void put(ToolContext& context);

    struct Held {
        csg::OccurrenceId occurrence = csg::kNoOccurrence;
        glm::dvec2 pointer{0};
    };
    std::optional<Held> held_;
    std::string typed_;
};

}  // namespace ui
