#include "ui/viewer/tools/measure_tool.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ui/pipeline/inspection/measured_text.h"
#include "ui/viewer/tool.h"
#include "ui/viewer/tools/measured_marks.h"

namespace ui {

namespace {

constexpr double kCornerReach = 11, kEdgeReach = 8;  // Units from the pointer within which these are meant.

/// What is meant by a place: the corner or the edge near it, else the face.
std::optional<Measured> meant(const ToolContext& context, const ToolAnswer& answer) {
    const double scale = static_cast<double>(context.scale);
    const auto near = [&](const std::optional<Measured>& thing, double reach) {
        return thing && answer.surface &&
               distance_on_screen(context.camera, context.picture, *thing, answer.surface->point, answer.at) <=
                   reach * scale;
    };
    if (near(answer.corner, kCornerReach)) {
        return answer.corner;
    }
    return near(answer.edge, kEdgeReach) ? answer.edge : answer.face;
}

std::string model_text(const csg::Box& box) {
    const glm::dvec3 size = box.size();
    return fmt::format("model {:.6g} × {:.6g} × {:.6g}\n   from [{:.6g}, {:.6g}, {:.6g}] to [{:.6g}, {:.6g}, {:.6g}]\n",
                       size.x, size.y, size.z, box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z);
}

class MeasureTool : public Tool {
  public:
    void begin(ToolContext& context) override { tell(context); }
    void end(ToolContext& /*context*/) override {
        things_.clear();
        hovered_.reset();
        text_.clear();
    }

    bool hover(ToolContext& context, const std::optional<glm::dvec2>& at) override {
        context.question = at;
        return !at && std::exchange(hovered_, std::nullopt).has_value();
    }

    void click(ToolContext& context, const glm::dvec2& at) override { context.question = clicked_ = at; }

    void answer(ToolContext& context, const ToolAnswer& answer) override {
        if (model_ != context.session.document().model()) {
            things_.clear();  // They were of another.
        }
        hovered_ = meant(context, answer);
        if (clicked_ == answer.at) {
            clicked_.reset();
            if (things_.size() == 2) {
                things_.clear();
            }
            if (hovered_) {
                things_.push_back(*hovered_);
            }
        }
        tell(context);
    }

    bool cancel(ToolContext& context) override {
        const bool any = !things_.empty();
        things_.clear();
        tell(context);
        return any;
    }

    [[nodiscard]] std::string text() const override { return text_; }

    void draw(const ToolContext& context, const ToolPainter& painter) const override {
        const auto& model = context.session.document().model();
        if (!model || model->empty()) {
            return;
        }
        const MeasuredMarks marks{painter, context.camera, context.picture};
        if (model_ == model) {
            if (things_.empty() && !hovered_) {
                marks.box(model->box, IM_COL32(76, 148, 240, 160));
            }
            if (hovered_) {
                marks.thing(*hovered_, IM_COL32(255, 170, 40, 255));
            }
            for (const Measured& thing : things_) {
                marks.thing(thing, IM_COL32(76, 148, 240, 255));
            }
            if (things_.size() == 2) {
                marks.distance(relation_of(things_[0], things_[1]));
            }
        }
        marks.note(text_ + (things_.empty() && hovered_ ? "\n" + headline(*hovered_) : ""));
    }

  private:
    /// What is picked, or of the model where nothing is.
    void tell(const ToolContext& context) {
        const auto& document = context.session.document();
        model_ = document.model();
        text_.clear();
        if (!model_ || !document.model_sources()) {
            return;
        }
        if (things_.empty()) {
            text_ = model_->empty() ? "" : model_text(model_->box);
        }
        for (const Measured& thing : things_) {
            text_ += headline(thing) + "\n" + details(*model_, *document.model_sources(), thing);
        }
        if (things_.size() == 2) {
            text_ += relation_text(things_[0], things_[1], relation_of(things_[0], things_[1]));
        }
    }

    std::vector<Measured> things_;        ///< Two at most.
    std::optional<Measured> hovered_;     ///< What a click would take.
    std::optional<glm::dvec2> clicked_;   ///< What lies there is to be taken once it is known.
    std::shared_ptr<const Model> model_;  ///< That they are of.
    std::string text_;
};

}  // namespace

std::unique_ptr<Tool> make_measure_tool() {
    return std::make_unique<MeasureTool>();
}

}  // namespace ui
