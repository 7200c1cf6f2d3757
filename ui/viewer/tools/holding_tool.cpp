#include "ui/viewer/tools/holding_tool.h"

#include <GLFW/glfw3.h>

#include "ui/viewer/tools/drag_text.h"

namespace ui {

void HoldingTool::hold(const ToolContext& context, const glm::dvec2& at) {
    typed_.clear();
    if (context.session.can_move()) {
        held_ = Held{context.session.selected_occurrence(), at};
    }
}

void HoldingTool::drag(ToolContext& context, const glm::dvec2& at) {
    if (!held_) {
        return;
    }
    if (context.session.selected_occurrence() != held_->occurrence) {
        (void)cancel(context);  // There is another model, in which it is not.
        return;
    }
    held_->pointer = at;
    follow(context, at);
    context.commands.emplace_back(HoldPart{held()});
}

void HoldingTool::put(ToolContext& context) {
    context.commands.emplace_back(PutPart{held()});
    held_.reset();
    typed_.clear();
}

void HoldingTool::release(ToolContext& context, const glm::dvec2& /*at*/) {
    if (held_) {
        put(context);
    }
}

void HoldingTool::click(ToolContext& context, const glm::dvec2& at) {
    context.commands.emplace_back(SelectAt{at - glm::dvec2(context.picture.corner)});
}

bool HoldingTool::key(ToolContext& context, const KeyEvent& event) {
    if (!held_) {
        return false;
    }
    if (ends_drag(event)) {
        put(context);
    } else if (type_number(event, typed_)) {
        context.commands.emplace_back(HoldPart{held()});
    } else {
        return event.chord.key != GLFW_KEY_ESCAPE;
    }
    return true;
}

bool HoldingTool::cancel(ToolContext& context) {
    if (!held_) {
        return false;
    }
    held_.reset();
    context.commands.emplace_back(HoldPart{});
    return true;
}

std::string HoldingTool::text() const {
    return !held_ ? "" : typed_.empty() ? words() : words() + "   " + typed_ + "_";
}

void HoldingTool::draw_words(const ToolPainter& painter) const {
    if (held_) {
        draw_drag_text(text(), held_->pointer, painter);
    }
}

}  // namespace ui
