#include "ui/viewer/tools/select_tool.h"

#include "ui/viewer/tool.h"

namespace ui {

namespace {

class SelectTool : public Tool {
  public:
    void click(ToolContext& context, const glm::dvec2& at) override {
        context.commands.emplace_back(SelectAt{at - glm::dvec2(context.picture.corner)});
    }
};

}  // namespace

std::unique_ptr<Tool> make_select_tool() {
    return std::make_unique<SelectTool>();
}

}  // namespace ui
