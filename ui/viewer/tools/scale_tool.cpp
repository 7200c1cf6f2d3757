#include "ui/viewer/tools/scale_tool.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "ui/pipeline/editing/text_edit.h"
#include "ui/viewer/picture_places.h"
#include "ui/viewer/tools/gizmo_color.h"
#include "ui/viewer/tools/holding_tool.h"
#include "ui/viewer/window_point.h"

namespace ui {

namespace {

constexpr double kScaleArm = 80, kScaleGrip = 9;            // Units of the window.
constexpr double kFineFactor = 0.05, kCoarseFactor = 0.25;  // Steps of factors.
constexpr std::size_t kEven = 3;  ///< The handle that scales along all axes, after those of each.

/// Where the handles are: at the ends of the axes that the first leaf of what is selected has of its own.
struct ScaleFrame {
    glm::dvec3 pivot{0};
    glm::dmat3 axes{1.0};
};

class ScaleTool : public HoldingTool {
  public:
    bool hover(ToolContext& context, const std::optional<glm::dvec2>& at) override {
        const auto handle = at ? handle_at(context, *at) : std::nullopt;
        return std::exchange(over_, handle) != handle;
    }

    bool press(ToolContext& context, const PointerEvent& event) override {
        const auto handle = event.button == Button::Left ? handle_at(context, event.position) : std::nullopt;
        if (!handle) {
            return false;
        }
        over_ = handle;
        drag_ = {*handle, *frame_of(context), event.position, 1};
        hold(context, event.position);
        return true;
    }

    void end(ToolContext& context) override {
        over_.reset();
        (void)cancel(context);
    }

    void draw(const ToolContext& context, const ToolPainter& painter) const override {
        const auto frame = holds() ? std::optional(drag_.frame) : frame_of(context);
        const auto middle = frame ? place_of(context.camera, context.picture, frame->pivot) : std::nullopt;
        if (!middle) {
            return;
        }
        const Rectangle& place = context.picture;
        painter.list.PushClipRect({place.corner.x, place.corner.y},
                                  {place.corner.x + place.size.x, place.corner.y + place.size.y});
        const auto hovered = holds() ? std::optional(drag_.handle) : over_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (const auto tip = tip_of(context, *frame, axis)) {
                draw_handle(*middle, *tip, gizmo_color(axis, hovered == axis), painter);
            }
        }
        draw_square(*middle, hovered == kEven ? kGizmoHovered : IM_COL32(245, 245, 245, 255), painter);
        draw_words(painter);
        painter.list.PopClipRect();
    }

  private:
    struct Drag {
        std::size_t handle = kEven;
        ScaleFrame frame;       ///< As it was gripped, …
        glm::dvec2 gripped{0};  ///< … there in the window.
        double factor = 1;
    };

    [[nodiscard]] static std::optional<ScaleFrame> frame_of(const ToolContext& context) {
        const auto& model = context.session.document().model();
        const csg::OccurrenceId selected = context.session.selected_occurrence();
        if (!model || selected == csg::kNoOccurrence || selected >= model->scene.occurrences.size()) {
            return std::nullopt;
        }
        const csg::LeafId leaf = first_leaf_below(model->scene, selected);
        if (leaf >= model->scene.leaves.size()) {
            return std::nullopt;
        }
        const glm::dmat4& to_world = model->scene.leaves[leaf].to_world;
        ScaleFrame frame{glm::dvec3(to_world[3]), glm::dmat3(to_world)};
        if (std::abs(glm::determinant(frame.axes)) < 1e-12) {
            return std::nullopt;
        }
        for (int i = 0; i < 3; ++i) {
            frame.axes[i] = glm::normalize(frame.axes[i]);
        }
        return frame;
    }

    /// Nothing where the axis points to the eye.
    [[nodiscard]] static std::optional<glm::dvec2> tip_of(const ToolContext& context, const ScaleFrame& frame,
                                                          std::size_t axis) {
        const double arm =
            kScaleArm * static_cast<double>(context.scale) * unit_at(context.camera, context.picture, frame.pivot);
        const auto middle = place_of(context.camera, context.picture, frame.pivot);
        const auto tip =
            place_of(context.camera, context.picture, frame.pivot + arm * frame.axes[static_cast<int>(axis)]);
        const double least = 2 * kScaleGrip * static_cast<double>(context.scale);
        return middle && tip && glm::distance(*middle, *tip) > least ? tip : std::nullopt;
    }

    [[nodiscard]] static std::optional<std::size_t> handle_at(const ToolContext& context, const glm::dvec2& at) {
        const auto frame = frame_of(context);
        const auto middle = frame ? place_of(context.camera, context.picture, frame->pivot) : std::nullopt;
        if (!middle) {
            return std::nullopt;
        }
        const double grip = kScaleGrip * static_cast<double>(context.scale);
        if (glm::distance(*middle, at) <= grip) {
            return kEven;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto tip = tip_of(context, *frame, axis);
            if (tip && std::min(distance_to_segment(at, glm::mix(*middle, *tip, 0.4), *tip), glm::distance(at, *tip)) <=
                           grip) {
                return axis;
            }
        }
        return std::nullopt;
    }

    void follow(const ToolContext& context, const glm::dvec2& at) override {
        const double arm = kScaleArm * static_cast<double>(context.scale);
        double factor = 1;
        if (drag_.handle == kEven) {
            // To the right and up it grows, twofold for the length of a handle.
            factor = std::exp2(((at.x - drag_.gripped.x) - (at.y - drag_.gripped.y)) / arm);
        } else {
            const auto middle = place_of(context.camera, context.picture, drag_.frame.pivot);
            const auto tip = tip_of(context, drag_.frame, drag_.handle);
            if (!middle || !tip) {
                return;
            }
            const glm::dvec2 way = *tip - *middle;
            const double begun = glm::dot(drag_.gripped - *middle, way), now = glm::dot(at - *middle, way);
            factor = begun > 0 ? now / begun : 1;
        }
        const bool coarse = context.held(GLFW_KEY_LEFT_CONTROL) || context.held(GLFW_KEY_RIGHT_CONTROL);
        const double step = coarse ? kCoarseFactor : kFineFactor;
        drag_.factor = std::max(std::round(factor / step) * step, step);
    }

    [[nodiscard]] double factor() const {
        const double number = std::strtod(typed().c_str(), nullptr);
        return number > 0 ? number : drag_.factor;
    }

    [[nodiscard]] HeldPart held() const override {
        HeldPart part{held_occurrence(), {}, {}, drag_.frame.pivot};
        part.axes = drag_.frame.axes;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            part.scale[static_cast<int>(axis)] = drag_.handle == kEven || drag_.handle == axis ? factor() : 1;
        }
        return part;
    }

    [[nodiscard]] std::string words() const override {
        const std::string times = "× " + short_number(factor(), 1e-6);
        return drag_.handle == kEven ? times : fmt::format("{} {}", "XYZ"[drag_.handle], times);
    }

    static void draw_square(const glm::dvec2& at, ImU32 color, const ToolPainter& painter) {
        const auto rectangle = [&](float half, ImU32 fill) {
            const ImVec2 p = window_point(at);
            half *= painter.scale;
            painter.list.AddRectFilled({p.x - half, p.y - half}, {p.x + half, p.y + half}, fill);
        };
        rectangle(7, kGizmoShade);
        rectangle(5.5F, color);
    }

    static void draw_handle(const glm::dvec2& from, const glm::dvec2& tip, ImU32 color, const ToolPainter& painter) {
        const glm::dvec2 begin = glm::mix(from, tip, 0.16);
        painter.list.AddLine(window_point(begin), window_point(tip), kGizmoShade, 5.5F * painter.scale);
        painter.list.AddLine(window_point(begin), window_point(tip), color, 3 * painter.scale);
        draw_square(tip, color, painter);
    }

    std::optional<std::size_t> over_;
    Drag drag_;  ///< As long as it holds something.
};

}  // namespace

std::unique_ptr<Tool> make_scale_tool() {
    return std::make_unique<ScaleTool>();
}

}  // namespace ui
