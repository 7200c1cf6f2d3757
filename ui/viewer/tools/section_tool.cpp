#include "ui/viewer/tools/section_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/viewer/picture_places.h"
#include "ui/viewer/tool.h"
#include "ui/viewer/window_point.h"

namespace ui {

namespace {

constexpr double kArm = 44, kReach = 9;  // Length of an arrow, and how near the pointer must come, in units.

/// The only section, where that is a plane; null otherwise.
const npr::PlaneSection* plane_of(const Session& session) {
    const npr::Sections& sections = session.view().picture.sections;
    return sections.cuts.size() == 1 ? std::get_if<npr::PlaneSection>(&sections.cuts[0].cut) : nullptr;
}

/// The middle of the model, moved into the plane.
glm::dvec3 middle(const npr::PlaneSection& plane, const csg::Box& box) {
    return box.center() + plane.normal * (plane.offset - glm::dot(plane.normal, box.center()));
}

class SectionTool : public Tool {
  public:
    bool hover(ToolContext& context, const std::optional<glm::dvec2>& at) override {
        const auto handle = at ? handle_of(context) : std::nullopt;
        const bool over = handle && near(*handle, *at);
        return std::exchange(over_, over) != over;
    }

    bool press(ToolContext& context, const PointerEvent& event) override {
        const auto handle = handle_of(context);
        if (event.button != Button::Left || !handle || !near(*handle, event.position)) {
            return false;
        }
        const npr::PlaneSection& plane = *plane_of(context.session);
        origin_ = middle(plane, context.session.document().model()->box);
        normal_ = plane.normal;
        offset_ = plane.offset;
        gripped_ = along(context, event.position);
        over_ = true;
        return gripped_.has_value();
    }

    void drag(ToolContext& context, const glm::dvec2& at) override {
        const auto now = along(context, at);
        const auto& model = context.session.document().model();
        if (!now || !model || plane_of(context.session) == nullptr) {
            return;
        }
        // What is beyond the model cuts nothing, or everything.
        const glm::dvec3 center = model->box.center();
        const double half = glm::dot(glm::abs(normal_), 0.5 * model->box.size()), at_center = glm::dot(normal_, center);
        npr::Sections moved = context.session.view().picture.sections;
        std::get<npr::PlaneSection>(moved.cuts[0].cut).offset =
            std::clamp(offset_ + *now - *gripped_, at_center - half, at_center + half);
        context.commands.emplace_back(SetSections{moved});
    }

    void draw(const ToolContext& context, const ToolPainter& painter) const override {
        const auto handle = handle_of(context);
        if (!handle) {
            return;
        }
        const auto& [back, at, front] = *handle;
        const ImU32 color = over_ ? IM_COL32(76, 148, 240, 255) : IM_COL32(240, 240, 240, 255);
        for (const auto& [shade, width] : {std::pair(IM_COL32(20, 20, 20, 200), 5.0F), std::pair(color, 2.5F)}) {
            for (const glm::dvec2& tip : {back, front}) {
                arrow(painter, at, tip, shade, width);
            }
            painter.list.AddCircleFilled(window_point(at), (2 + width) * painter.scale, shade);
        }
    }

  private:
    using Handle = std::array<glm::dvec2, 3>;  ///< An arrow's point, the middle, the other's point.

    static void arrow(const ToolPainter& painter, const glm::dvec2& from, const glm::dvec2& tip, ImU32 color,
                      float width) {
        painter.list.AddLine(window_point(from), window_point(tip), color, width * painter.scale);
        const double length = glm::distance(from, tip);
        if (length > 1) {
            const glm::dvec2 way = (tip - from) / length * (7.0 * static_cast<double>(painter.scale));
            const glm::dvec2 side(-way.y, way.x);
            painter.list.AddLine(window_point(tip), window_point(tip - way + 0.6 * side), color, width * painter.scale);
            painter.list.AddLine(window_point(tip), window_point(tip - way - 0.6 * side), color, width * painter.scale);
        }
    }

    static std::optional<Handle> handle_of(const ToolContext& context) {
        const npr::PlaneSection* plane = plane_of(context.session);
        const auto& model = context.session.document().model();
        if (plane == nullptr || !model || model->empty()) {
            return std::nullopt;
        }
        const glm::dvec3 at = middle(*plane, model->box);
        const glm::dvec3 arm =
            kArm * static_cast<double>(context.scale) * unit_at(context.camera, context.picture, at) * plane->normal;
        const auto back = place_of(context.camera, context.picture, at - arm),
                   here = place_of(context.camera, context.picture, at),
                   front = place_of(context.camera, context.picture, at + arm);
        return back && here && front ? std::optional(Handle{*back, *here, *front}) : std::nullopt;
    }

    static bool near(const Handle& handle, const glm::dvec2& at) {
        return distance_to_segment(at, handle[0], handle[2]) <= kReach;
    }

    /// Where along the normal from origin_ the line of sight comes nearest to it; nothing where both are parallel.
    [[nodiscard]] std::optional<double> along(const ToolContext& context, const glm::dvec2& at) const {
        const base::View::Ray ray = sight(context.camera, context.picture, at);
        const glm::dvec3 direction = glm::normalize(ray.direction), between = origin_ - ray.origin;
        const double cosine = glm::dot(direction, normal_), square_of_sine = 1 - cosine * cosine;
        if (square_of_sine < 1e-4) {
            return std::nullopt;
        }
        return (cosine * glm::dot(direction, between) - glm::dot(normal_, between)) / square_of_sine;
    }

    bool over_ = false;
    glm::dvec3 origin_{0}, normal_{0, 0, 1};  ///< The line that is dragged along.
    double offset_ = 0;                       ///< Of the plane when it was gripped …
    std::optional<double> gripped_;           ///< … and where on the line that was.
};

}  // namespace

std::unique_ptr<Tool> make_section_tool() {
    return std::make_unique<SectionTool>();
}

}  // namespace ui
