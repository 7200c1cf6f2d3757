#include "ui/viewer/tools/size_tool.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "csg/scad/program/loaded_program.h"
#include "ui/pipeline/editing/added_shape.h"
#include "ui/pipeline/editing/shape_numbers.h"
#include "ui/viewer/picture_places.h"
#include "ui/viewer/tool.h"
#include "ui/viewer/tools/drag_text.h"
#include "ui/viewer/tools/side_handles.h"
#include "ui/viewer/window_point.h"

namespace ui {

namespace {

constexpr double kGrip = 9;                        // Units of the window, as is:
constexpr double kFineSize = 1.5, kGridSize = 12;  // A step is not shorter, freely and on the grid.
constexpr ImU32 kRest = IM_COL32(76, 148, 240, 255), kOver = IM_COL32(255, 140, 26, 255);
constexpr ImU32 kComputed = IM_COL32(168, 118, 232, 255);  // What the text computes.

/// Where a number is seen in the world, and the line that it is dragged along.
struct Place {
    glm::dvec3 at{0}, along{0};  ///< The latter of length 1.
    double scale = 1;            ///< World units of a unit of the leaf, along it.
};

/// A step is not shorter than so many units of the window; `unit`: what one is worth.
double step_for(const ToolContext& context, double unit) {
    const bool on_grid = context.held(GLFW_KEY_LEFT_CONTROL) || context.held(GLFW_KEY_RIGHT_CONTROL);
    const double least = (on_grid ? kGridSize : kFineSize) * static_cast<double>(context.scale) * unit;
    return round_number_above(least);
}

Place place_in_world(const ShapeNumber& number, const glm::dmat4& to_world) {
    const glm::dvec3 along = glm::dmat3(to_world) * number.along;
    const double scale = std::max(glm::length(along), 1e-12);
    return {glm::dvec3(to_world * glm::dvec4(number.at, 1)), along / scale, scale};
}

class SizeTool : public Tool {
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
        const bool side = *handle >= numbers_.size();
        const Place place = place_of_handle(*handle);
        const auto along = along_line(context, place, event.position);
        over_ = handle;
        typed_.clear();
        if (along) {
            drag_ = Drag{};
            drag_->handle = *handle;
            drag_->place = place;
            drag_->gripped = *along;
            drag_->pointer = event.position;
            drag_->occurrence = context.session.selected_occurrence();
            if (side) {
                drag_->side = sides_[*handle - numbers_.size()];
                drag_->name = drag_->side->name;
                drag_->begun = drag_->side->length;
            } else {
                drag_->number = numbers_[*handle];
                drag_->name = drag_->number.name;
                drag_->begun = drag_->number.value;
            }
            drag_->value = drag_->begun;
        }
        return true;
    }

    void drag(ToolContext& context, const glm::dvec2& at) override {
        if (!drag_) {
            return;
        }
        if (context.session.selected_occurrence() != drag_->occurrence) {
            drag_.reset();  // There is another model, in which it is not.
            return;
        }
        drag_->pointer = at;
        if (const auto now = along_line(context, drag_->place, at)) {
            const double per_world =
                drag_->side ? 1 / drag_->side->world_per_unit : drag_->number.per_unit / drag_->place.scale;
            const double step = step_for(context, unit_at(context.camera, context.picture, drag_->place.at) /
                                                      (drag_->side ? drag_->side->world_per_unit : drag_->place.scale));
            const double wanted = drag_->begun + (*now - drag_->gripped) * per_world;
            drag_->value = std::max(std::round(wanted / step) * step, step);
        }
        follow(context);
    }

    void release(ToolContext& context, const glm::dvec2& /*at*/) override { put(context); }

    void click(ToolContext& context, const glm::dvec2& at) override {
        context.commands.emplace_back(SelectAt{at - glm::dvec2(context.picture.corner)});
    }

    bool key(ToolContext& context, const KeyEvent& event) override {
        if (!drag_) {
            return false;
        }
        if (ends_drag(event)) {
            put(context);
        } else if (type_number(event, typed_)) {
            follow(context);
        } else {
            return event.chord.key != GLFW_KEY_ESCAPE;
        }
        return true;
    }

    bool cancel(ToolContext& context) override {
        if (!drag_) {
            return false;
        }
        typed_.clear();
        if (drag_->side) {
            context.commands.emplace_back(HoldPart{});
        } else {
            drag_->value = drag_->begun;
            follow(context);
        }
        drag_.reset();
        return true;
    }

    void end(ToolContext& context) override {
        over_.reset();
        (void)cancel(context);
    }

    /// "h 12"
    [[nodiscard]] std::string text() const override {
        return drag_ ? fmt::format("{} {}{}", drag_->name, value_text(), typed_.empty() ? "" : "_") : "";
    }

    void draw(const ToolContext& context, const ToolPainter& painter) const override {
        look(context);
        const Rectangle& place = context.picture;
        painter.list.PushClipRect({place.corner.x, place.corner.y},
                                  {place.corner.x + place.size.x, place.corner.y + place.size.y});
        for (std::size_t i = 0; i < numbers_.size() + sides_.size(); ++i) {
            draw_handle(context, i, drag_ ? drag_->handle == i : over_ == i, painter);
        }
        if (drag_) {
            draw_drag_text(text(), drag_->pointer, painter);
        }
        painter.list.PopClipRect();
    }

  private:
    struct Drag {
        std::size_t handle = 0;
        ShapeNumber number;              ///< As it was gripped, …
        std::optional<SideHandle> side;  ///< … or the side, …
        Place place;
        double gripped = 0;  ///< … there on the line.
        std::string name;
        double begun = 0, value = 0;
        glm::dvec2 pointer{0};
        csg::OccurrenceId occurrence = csg::kNoOccurrence;
        bool set = false;  ///< The text has followed.
    };

    [[nodiscard]] Place place_of_handle(std::size_t handle) const {
        if (handle < numbers_.size()) {
            return place_in_world(numbers_[handle], to_world_);
        }
        const SideHandle& side = sides_[handle - numbers_.size()];
        return {side.at, side.along, 1};
    }

    /// Finds the numbers of what is selected, where that is another than before.
    void look(const ToolContext& context) const {
        const auto& model = context.session.document().model();
        const csg::OccurrenceId selected = context.session.selected_occurrence();
        const std::pair key(model ? model->generation : 0, selected);
        // A program that runs cannot be looked at.
        if (key == numbers_of_ || context.session.evaluating()) {
            return;
        }
        numbers_of_ = key;
        numbers_.clear();
        sides_.clear();
        const csg::LeafId leaf = model ? first_leaf_below(model->scene, selected) : 0;
        if (!model || !model->program || !context.session.can_move() || leaf >= model->scene.leaves.size()) {
            return;
        }
        const csg::LeafInstance& instance = model->scene.leaves[leaf];
        const csg::Node& node = model->tree->node(instance.node);
        if (!node.where.known()) {
            return;
        }
        to_world_ = instance.to_world;
        if (node.operation == csg::Operation::Leaf) {
            numbers_ = written_numbers(context, *model, instance);
        }
        sides_ = side_handles(*model->tree, instance, numbers_);
    }

    [[nodiscard]] static std::vector<ShapeNumber> written_numbers(const ToolContext& context, const Model& model,
                                                                  const csg::LeafInstance& instance) {
        return model.program->look([&](const csg::scad::Program& program) -> std::vector<ShapeNumber> {
            csg::SourceLocation where = model.tree->node(instance.node).where;
            const bool main = model.tree->files()[where.file] == program.sources[program.units[0].file].name();
            const std::string& text = program.sources[program.units[0].file].text();
            where.file = program.units[0].file;
            const auto call = main && text == context.session.editing().text().text()
                                  ? csg::scad::call_at(program, where)
                                  : std::nullopt;
            return call ? shape_numbers(model.tree->shape(instance.node), *call, text) : std::vector<ShapeNumber>();
        });
    }

    [[nodiscard]] std::optional<std::size_t> handle_at(const ToolContext& context, const glm::dvec2& at) const {
        look(context);
        std::optional<std::size_t> nearest;
        double least = kGrip * static_cast<double>(context.scale);
        for (std::size_t i = 0; i < numbers_.size() + sides_.size(); ++i) {
            const auto seen = place_of(context.camera, context.picture, place_of_handle(i).at);
            if (seen && glm::distance(*seen, at) <= least) {
                nearest = i;
                least = glm::distance(*seen, at);
            }
        }
        return nearest;
    }

    /// How far on the line the line of sight comes nearest to it; nothing where both are parallel.
    [[nodiscard]] static std::optional<double> along_line(const ToolContext& context, const Place& place,
                                                          const glm::dvec2& at) {
        const base::View::Ray ray = sight(context.camera, context.picture, at);
        const glm::dvec3 direction = glm::normalize(ray.direction), between = place.at - ray.origin;
        const double cosine = glm::dot(direction, place.along), square_of_sine = 1 - cosine * cosine;
        if (square_of_sine < 1e-4) {
            return std::nullopt;
        }
        return (cosine * glm::dot(direction, between) - glm::dot(place.along, between)) / square_of_sine;
    }

    [[nodiscard]] std::string value_text() const {
        const double typed = std::strtod(typed_.c_str(), nullptr);
        return typed > 0 ? typed_ : short_number(drag_->value, 1e-9 * drag_->value);
    }

    [[nodiscard]] HeldPart held() const {
        const double value = std::strtod(value_text().c_str(), nullptr);
        return drag_->side->moved_out((value - drag_->begun) * drag_->side->world_per_unit);
    }

    /// What is written out changes in the text at once; what is computed, when it is let go.
    void follow(ToolContext& context) {
        if (drag_->side) {
            context.commands.emplace_back(HoldPart{held()});
            return;
        }
        context.commands.emplace_back(SetNumber{drag_->number.bytes, value_text(), !drag_->set, drag_->number.name});
        drag_->set = true;
    }

    void put(ToolContext& context) {
        if (drag_ && drag_->side) {
            context.commands.emplace_back(PutPart{held()});
        }
        drag_.reset();
        typed_.clear();
    }

    void draw_handle(const ToolContext& context, std::size_t handle, bool over, const ToolPainter& painter) const {
        const bool side = handle >= numbers_.size();
        const std::string& name = side ? sides_[handle - numbers_.size()].name : numbers_[handle].name;
        const double value = side ? sides_[handle - numbers_.size()].length : numbers_[handle].value;
        const Place place = place_of_handle(handle);
        const double unit = unit_at(context.camera, context.picture, place.at) * static_cast<double>(painter.scale);
        const auto at = place_of(context.camera, context.picture, place.at),
                   tip = place_of(context.camera, context.picture, place.at + 26 * unit * place.along);
        if (!at || !tip) {
            return;
        }
        const ImU32 color = over ? kOver : side ? kComputed : kRest;
        painter.list.AddLine(window_point(*at), window_point(*tip), IM_COL32(20, 20, 20, 150), 4.5F * painter.scale);
        painter.list.AddLine(window_point(*at), window_point(*tip), color, 2.5F * painter.scale);
        painter.list.AddCircleFilled(window_point(*at), 7 * painter.scale, IM_COL32(20, 20, 20, 150));
        painter.list.AddCircleFilled(window_point(*at), 5.5F * painter.scale, color);
        const ImFont& font = *painter.fonts.bold;
        const std::string label = fmt::format("{} {}", name, short_number(value, 1e-6 * value));
        const ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, label.c_str());
        const glm::dvec2 away = glm::distance(*at, *tip) > 1 ? glm::normalize(*tip - *at) : glm::dvec2(0, -1);
        const ImVec2 middle = window_point(*tip + away * 14.0 * static_cast<double>(painter.scale));
        const ImVec2 corner{middle.x - 0.5F * size.x, middle.y - 0.5F * size.y};
        painter.list.AddRectFilled({corner.x - 3, corner.y - 1}, {corner.x + size.x + 3, corner.y + size.y + 1},
                                   IM_COL32(24, 27, 31, 200), 3 * painter.scale);
        painter.list.AddText(&font, font.FontSize, corner, IM_COL32_WHITE, label.c_str());
    }

    std::optional<std::size_t> over_;
    std::optional<Drag> drag_;
    std::string typed_;
    mutable std::pair<std::uint64_t, csg::OccurrenceId> numbers_of_{~std::uint64_t{0}, csg::kNoOccurrence};
    mutable std::vector<ShapeNumber> numbers_;  ///< Of that model's leaf, …
    mutable std::vector<SideHandle> sides_;  ///< … with what of it is computed; handles are numbered in this order.
    mutable glm::dmat4 to_world_{1.0};       ///< Where it lies.
};

}  // namespace

std::unique_ptr<Tool> make_size_tool() {
    return std::make_unique<SizeTool>();
}

}  // namespace ui
