#include "ui/viewer/toolbox.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ui {

Toolbox::Toolbox(std::span<const ToolInfo> infos) : infos_(infos) {
    for (const ToolInfo& each : infos) {
        tools_.push_back(each.make());
    }
    const auto first = std::find_if(infos.begin(), infos.end(), [](const ToolInfo& each) { return each.action; });
    used_ = static_cast<std::size_t>(std::distance(infos.begin(), first));
}

/// Is it so of one of the tools that lie at hand or of that which is used? The first one ends the search.
template <typename Each>
bool Toolbox::any(Each&& each) const {
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        if ((i == used_ || !infos_[i].action) && each(*tools_[i])) {
            return true;
        }
    }
    return false;
}

bool Toolbox::use(ToolContext& context, Action action) {
    const auto found =
        std::find_if(infos_.begin(), infos_.end(), [&](const ToolInfo& each) { return each.action == action; });
    if (found == infos_.end()) {
        return false;
    }
    dragged_ = nullptr;
    tools_[used_]->end(context);
    used_ = static_cast<std::size_t>(std::distance(infos_.begin(), found));
    tools_[used_]->begin(context);
    return true;
}

bool Toolbox::handle(ToolContext& context, const PointerEvent& event, bool free) {
    const bool inside = free && context.picture.contains(event.position);
    switch (event.kind) {
        case PointerKind::Press:
            return dragged_ != nullptr || (inside && any([&](Tool& tool) {
                                               const bool taken = tool.press(context, event);
                                               if (taken) {
                                                   dragged_ = &tool;
                                                   button_ = event.button;
                                               }
                                               return taken;
                                           }));
        case PointerKind::Release:
            if (dragged_ == nullptr || event.button != button_) {
                return false;
            }
            std::exchange(dragged_, nullptr)->release(context, event.position);
            return true;
        case PointerKind::Move:
            if (dragged_ != nullptr) {
                dragged_->drag(context, event.position);
            }
            return dragged_ != nullptr;
        case PointerKind::Scroll:
            return inside && any([&](Tool& tool) { return tool.scroll(context, event); });
    }
    return false;
}

void Toolbox::click(ToolContext& context, const glm::dvec2& at) {
    tools_[used_]->click(context, at);
}

bool Toolbox::hover(ToolContext& context, const std::optional<glm::dvec2>& at) {
    bool changed = false;
    (void)any([&](Tool& tool) {
        changed |= tool.hover(context, at);
        return false;
    });
    return changed;
}

bool Toolbox::key(ToolContext& context, const KeyEvent& event) {
    return any([&](Tool& tool) { return tool.key(context, event); });
}

bool Toolbox::cancel(ToolContext& context) {
    dragged_ = nullptr;
    if (any([&](Tool& tool) { return tool.cancel(context); })) {
        return true;
    }
    const auto first = std::find_if(infos_.begin(), infos_.end(), [](const ToolInfo& each) { return each.action; });
    return first->action != infos_[used_].action && use(context, *first->action);
}

bool Toolbox::advance(ToolContext& context, double seconds) {
    bool goes_on = false;
    (void)any([&](Tool& tool) {
        goes_on |= tool.advance(context, seconds);
        return false;
    });
    return goes_on;
}

void Toolbox::answer(ToolContext& context, const ToolAnswer& answer) {
    tools_[used_]->answer(context, answer);
}

void Toolbox::draw(const ToolContext& context, const ToolPainter& painter) const {
    (void)any([&](const Tool& tool) {
        tool.draw(context, painter);
        return false;
    });
}

}  // namespace ui
