#include "ui/viewer/tools/turn_tool.h"

#include <GLFW/glfw3.h>

#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "ui/pipeline/editing/text_edit.h"
#include "ui/viewer/tools/gizmo_color.h"
#include "ui/viewer/tools/holding_tool.h"
#include "ui/viewer/tools/turn_rings.h"
#include "ui/viewer/window_point.h"

namespace ui {

namespace {

constexpr double kWholeDegree = 1, kCoarseDegrees = 15;

/// From -180 on, below 180.
double within_a_turn(double degrees) {
    return degrees - 360 * std::floor((degrees + 180) / 360);
}

class TurnTool : public HoldingTool {
  public:
    bool hover(ToolContext& context, const std::optional<glm::dvec2>& at) override {
        const auto pivot = pivot_of(context);
        const auto axis = at && pivot ? rings(context, *pivot).axis_at(*at) : std::nullopt;
        return std::exchange(over_, axis) != axis;
    }

    bool press(ToolContext& context, const PointerEvent& event) override {
        const auto pivot = pivot_of(context);
        if (event.button != Button::Left || !pivot) {
            return false;
        }
        const TurnRings shown = rings(context, *pivot);
        const auto axis = shown.axis_at(event.position);
        const auto angle = axis ? shown.angle_at(*axis, event.position) : std::nullopt;
        if (!angle) {
            return false;
        }
        over_ = axis;
        drag_ = {*axis, *pivot, *angle, 0};
        hold(context, event.position);
        return true;
    }

    void end(ToolContext& context) override {
        over_.reset();
        (void)cancel(context);
    }

    void draw(const ToolContext& context, const ToolPainter& painter) const override {
        const auto pivot = holds() ? std::optional(drag_.pivot) : pivot_of(context);
        if (!pivot) {
            return;
        }
        const Rectangle& place = context.picture;
        painter.list.PushClipRect({place.corner.x, place.corner.y},
                                  {place.corner.x + place.size.x, place.corner.y + place.size.y});
        const TurnRings shown = rings(context, *pivot);
        for (const bool behind : {true, false}) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                draw_ring(shown.ring(axis), axis, behind, painter);
            }
        }
        draw_words(painter);
        painter.list.PopClipRect();
    }

  private:
    struct Drag {
        std::size_t axis = 0;
        glm::dvec3 pivot{0};
        double gripped = 0;  ///< Degrees: where the ring was.
        double degrees = 0;
    };

    void follow(const ToolContext& context, const glm::dvec2& at) override {
        if (const auto now = rings(context, drag_.pivot).angle_at(drag_.axis, at)) {
            const bool coarse = context.held(GLFW_KEY_LEFT_CONTROL) || context.held(GLFW_KEY_RIGHT_CONTROL);
            const double step = coarse ? kCoarseDegrees : kWholeDegree;
            drag_.degrees = within_a_turn(std::round((*now - drag_.gripped) / step) * step);
        }
    }

    /// The origin of the first leaf of what is selected, as the text puts it: what its edits turn it about.
    [[nodiscard]] static std::optional<glm::dvec3> pivot_of(const ToolContext& context) {
        const auto& model = context.session.document().model();
        const csg::OccurrenceId selected = context.session.selected_occurrence();
        if (!model || selected == csg::kNoOccurrence || selected >= model->scene.occurrences.size()) {
            return std::nullopt;
        }
        const csg::LeafId leaf = first_leaf_below(model->scene, selected);
        return leaf < model->scene.leaves.size() ? std::optional(glm::dvec3(model->scene.leaves[leaf].to_world[3]))
                                                 : std::nullopt;
    }

    [[nodiscard]] static TurnRings rings(const ToolContext& context, const glm::dvec3& pivot) {
        return {context.camera, context.picture, pivot, context.scale};
    }

    [[nodiscard]] double degrees() const {
        char* end = nullptr;
        const double number = std::strtod(typed().c_str(), &end);
        return end != typed().c_str() ? within_a_turn(number) : drag_.degrees;
    }

    [[nodiscard]] HeldPart held() const override {
        HeldPart part{held_occurrence(), {}, {}, drag_.pivot};
        part.turn[static_cast<int>(drag_.axis)] = degrees();
        return part;
    }

    [[nodiscard]] std::string words() const override {
        return fmt::format("{} {}°", "XYZ"[drag_.axis], short_number(degrees(), 1e-6));
    }

    void draw_ring(const std::vector<TurnRings::Corner>& corners, std::size_t axis, bool behind,
                   const ToolPainter& painter) const {
        const bool over = (holds() ? std::optional(drag_.axis) : over_) == axis;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (corners[i].behind != behind) {
                continue;
            }
            const ImVec2 from = window_point(corners[i].at), to = window_point(corners[(i + 1) % corners.size()].at);
            if (!behind) {
                painter.list.AddLine(from, to, kGizmoShade, 5.5F * painter.scale);
            }
            painter.list.AddLine(from, to, gizmo_color(axis, over, behind ? 110 : 255),
                                 (behind ? 1.5F : 3.0F) * painter.scale);
        }
    }

    std::optional<std::size_t> over_;
    Drag drag_;  ///< As long as it holds something.
};

}  // namespace

std::unique_ptr<Tool> make_turn_tool() {
    return std::make_unique<TurnTool>();
}

}  // namespace ui
