// The tools of the window: hands input to those that lie at hand, and to the one that is used.
#pragma once

#include <memory>
#include <vector>

#include "ui/viewer/tool.h"
#include "ui/viewer/tools.h"

namespace ui {

class Toolbox {
  public:
    explicit Toolbox(std::span<const ToolInfo> infos = tools());

    /// Takes the tool of the action in hand. False where none has that action.
    bool use(ToolContext& context, Action action);
    /// The action of the tool in hand.
    [[nodiscard]] Action used() const { return *infos_[used_].action; }
    [[nodiscard]] const ToolInfo& info() const { return infos_[used_]; }

    /// True where a tool has taken the event; the camera gets it otherwise. `free`: no panel lies over the picture
    /// there.
    bool handle(ToolContext& context, const PointerEvent& event, bool free);
    /// The picture was clicked, which no tool had taken as a drag.
    void click(ToolContext& context, const glm::dvec2& at);
    /// The pointer moves with nothing held; nothing: it has left the picture. True where something is to be drawn anew.
    bool hover(ToolContext& context, const std::optional<glm::dvec2>& at);
    bool key(ToolContext& context, const KeyEvent& event);
    /// Gives up what is under way; else goes back to the first tool. False where neither is to be done.
    bool cancel(ToolContext& context);
    /// True where something goes on by itself.
    bool advance(ToolContext& context, double seconds);
    /// To the tool in hand.
    void answer(ToolContext& context, const ToolAnswer& answer);
    void draw(const ToolContext& context, const ToolPainter& painter) const;
    /// Of the tool in hand.
    [[nodiscard]] std::string text() const { return tools_[used_]->text(); }

    /// A tool has a drag.
    [[nodiscard]] bool dragging() const { return dragged_ != nullptr; }

  private:
    template <typename Each>
    bool any(Each&& each) const;

    std::span<const ToolInfo> infos_;
    std::vector<std::unique_ptr<Tool>> tools_;
    std::size_t used_ = 0;     ///< Index of the tool in hand.
    Tool* dragged_ = nullptr;  ///< Whose drag it is that goes on.
    Button button_ = Button::None;
};

}  // namespace ui
