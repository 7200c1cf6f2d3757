#include "ui/viewer/tools/move_tool.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ui/pipeline/editing/added_shape.h"
#include "ui/pipeline/editing/text_edit.h"
#include "ui/viewer/picture_places.h"
#include "ui/viewer/tools/gizmo_color.h"
#include "ui/viewer/tools/holding_tool.h"
#include "ui/viewer/tools/move_gizmo.h"
#include "ui/viewer/tools/snap_places.h"
#include "ui/viewer/window_point.h"

namespace ui {

namespace {

/// Units of the window that a step is not shorter than, freely and on the grid.
constexpr double kFine = 1.5, kGrid = 12;
constexpr double kSnapReach = 10;  // Units of the window, too.

class MoveTool : public HoldingTool {
  public:
    bool hover(ToolContext& context, const std::optional<glm::dvec2>& at) override {
        const auto box = box_of(context);
        const auto handle = at && box ? gizmo(context, *box).handle_at(*at) : std::nullopt;
        return std::exchange(over_, handle) != handle;
    }

    bool press(ToolContext& context, const PointerEvent& event) override {
        const auto box = box_of(context);
        if (event.button != Button::Left || !box) {
            return false;
        }
        const MoveGizmo shown = gizmo(context, *box);
        const auto handle = shown.handle_at(event.position);
        const auto gripped = handle ? shown.grip(*handle, event.position) : std::nullopt;
        if (!gripped) {
            return false;
        }
        over_ = handle;
        drag_ = {*handle, *box, *gripped, glm::dvec3(0), {}};
        places_.reset();
        hold(context, event.position);
        return true;
    }

    void end(ToolContext& context) override {
        over_.reset();
        (void)cancel(context);
    }

    void draw(const ToolContext& context, const ToolPainter& painter) const override {
        const auto box = box_of(context);
        if (!box) {
            return;
        }
        const Rectangle& place = context.picture;
        painter.list.PushClipRect({place.corner.x, place.corner.y},
                                  {place.corner.x + place.size.x, place.corner.y + place.size.y});
        draw_handles(gizmo(context, *box), painter);
        draw_snaps(context, painter);
        draw_words(painter);
        painter.list.PopClipRect();
    }

  private:
    struct Drag {
        MoveHandle handle = MoveHandle::Free;
        csg::Box box;           ///< As it was gripped, …
        glm::dvec3 gripped{0};  ///< … from its center, there.
        glm::dvec3 by{0};
        std::array<std::optional<SnappedPlace>, 3> snapped;  ///< By axis: what it lies in line with.
    };

    void follow(const ToolContext& context, const glm::dvec2& at) override {
        const MoveGizmo begun(context.camera, context.picture, drag_.box.center(), context.scale);
        if (const auto now = begun.grip(drag_.handle, at)) {
            const bool on_grid = context.held(GLFW_KEY_LEFT_CONTROL) || context.held(GLFW_KEY_RIGHT_CONTROL);
            const double step =
                round_number_above((on_grid ? kGrid : kFine) * static_cast<double>(context.scale) * begun.unit());
            drag_.by = in_steps(*now - drag_.gripped, drag_.handle, step);
            drag_.snapped = {};
            if (context.held(GLFW_KEY_LEFT_SHIFT) || context.held(GLFW_KEY_RIGHT_SHIFT)) {
                snap(context, *now - drag_.gripped, kSnapReach * static_cast<double>(context.scale) * begun.unit());
            }
        }
    }

    void snap(const ToolContext& context, const glm::dvec3& by, double reach) {
        if (!places_) {
            places_.emplace(*context.session.document().model(), held_occurrence());
        }
        const std::array<bool, 3> moves = axes_of(drag_.handle);
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            drag_.snapped[i] = moves[i] ? places_->near(axis, by[axis], reach) : std::nullopt;
            drag_.by[axis] = drag_.snapped[i] ? drag_.snapped[i]->by : drag_.by[axis];
        }
    }

    /// A line between what lies in line.
    void draw_snaps(const ToolContext& context, const ToolPainter& painter) const {
        if (!holds() || !typed().empty()) {
            return;
        }
        for (const auto& snapped : drag_.snapped) {
            if (snapped) {
                draw_snap(place_of(context.camera, context.picture, snapped->own + drag_.by),
                          place_of(context.camera, context.picture, snapped->other), painter);
            }
        }
    }

    static void draw_snap(const std::optional<glm::dvec2>& own, const std::optional<glm::dvec2>& other,
                          const ToolPainter& painter) {
        if (!own || !other) {
            return;
        }
        const ImVec2 from = window_point(*own), to = window_point(*other);
        painter.list.AddLine(from, to, kGizmoShade, 3.5F * painter.scale);
        painter.list.AddLine(from, to, kGizmoHovered, 1.5F * painter.scale);
        painter.list.AddCircleFilled(from, 4 * painter.scale, kGizmoHovered);
        painter.list.AddCircleFilled(to, 4 * painter.scale, kGizmoHovered);
    }

    /// Of what is selected, as the text puts it.
    [[nodiscard]] std::optional<csg::Box> box_of(const ToolContext& context) const {
        const auto& model = context.session.document().model();
        const csg::OccurrenceId selected = context.session.selected_occurrence();
        if (!model || selected == csg::kNoOccurrence) {
            return std::nullopt;
        }
        if (std::pair key(model->generation, selected); key != box_of_) {
            box_of_ = key;
            box_ = box_below(*model, selected);
        }
        return box_.empty() ? std::nullopt : std::optional(box_);
    }

    /// At its center, where it is held.
    [[nodiscard]] static MoveGizmo gizmo(const ToolContext& context, const csg::Box& box) {
        return {context.camera, context.picture, box.center() + context.session.held().by, context.scale};
    }

    [[nodiscard]] glm::dvec3 way() const { return typed_way(typed(), drag_.handle, drag_.by); }

    [[nodiscard]] HeldPart held() const override { return {held_occurrence(), way()}; }

    [[nodiscard]] std::string words() const override {
        const std::array<bool, 3> moves = axes_of(drag_.handle);
        const glm::dvec3 by = way();
        std::string text;
        for (std::size_t i = 0; i < 3; ++i) {
            if (moves[i]) {
                text += fmt::format("{}{} {}", text.empty() ? "" : "   ", "XYZ"[i],
                                    short_number(by[static_cast<int>(i)], 1e-6));
            }
        }
        return text;
    }

    void draw_handles(const MoveGizmo& shown, const ToolPainter& painter) const {
        const auto middle = shown.middle();
        if (!middle) {
            return;
        }
        const auto hovered = holds() ? std::optional(drag_.handle) : over_;
        for (const MoveHandle plane : {MoveHandle::YZ, MoveHandle::ZX, MoveHandle::XY}) {
            const auto corners = shown.square(plane);
            if (!corners) {
                continue;
            }
            const std::array<ImVec2, 4> at{window_point((*corners)[0]), window_point((*corners)[1]),
                                           window_point((*corners)[2]), window_point((*corners)[3])};
            const auto normal = static_cast<std::size_t>(plane) - static_cast<std::size_t>(MoveHandle::YZ);
            const bool over = hovered == plane;
            painter.list.AddQuadFilled(at[0], at[1], at[2], at[3], gizmo_color(normal, over, over ? 170 : 90));
            painter.list.AddQuad(at[0], at[1], at[2], at[3], gizmo_color(normal, over), 1.5F * painter.scale);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const auto handle = static_cast<MoveHandle>(i);
            if (const auto tip = shown.tip(handle)) {
                draw_arrow(glm::mix(*middle, *tip, 0.16), *tip, kGizmoShade, 5.5F, painter);
                draw_arrow(glm::mix(*middle, *tip, 0.16), *tip, gizmo_color(i, hovered == handle), 3, painter);
            }
        }
        const bool over = hovered == MoveHandle::Free;
        painter.list.AddCircleFilled(window_point(*middle), 7.5F * painter.scale, kGizmoShade);
        painter.list.AddCircleFilled(window_point(*middle), 5.5F * painter.scale,
                                     over ? kGizmoHovered : IM_COL32(245, 245, 245, 255));
    }

    static void draw_arrow(const glm::dvec2& from, const glm::dvec2& tip, ImU32 color, float width,
                           const ToolPainter& painter) {
        const double length = glm::distance(from, tip);
        if (length < 1) {
            return;
        }
        const double scale = static_cast<double>(painter.scale), more = 0.5 * static_cast<double>(width);
        const glm::dvec2 way = (tip - from) / length, side(-way.y, way.x);
        const glm::dvec2 base = tip - way * (13 * scale);
        painter.list.AddLine(window_point(from), window_point(base), color, width * painter.scale);
        painter.list.AddTriangleFilled(window_point(tip + way * (more * scale)),
                                       window_point(base + side * ((4 + more) * scale)),
                                       window_point(base - side * ((4 + more) * scale)), color);
    }

    std::optional<MoveHandle> over_;
    Drag drag_;                         ///< As long as it holds something.
    std::optional<SnapPlaces> places_;  ///< Of the model in which it does.
    mutable std::pair<std::uint64_t, csg::OccurrenceId> box_of_{0, csg::kNoOccurrence};  ///< What box_ is of.
    mutable csg::Box box_;
};

}  // namespace

std::unique_ptr<Tool> make_move_tool() {
    return std::make_unique<MoveTool>();
}

}  // namespace ui
