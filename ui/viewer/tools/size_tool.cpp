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
#include "ui/viewer/window_point.h"

namespace ui {

namespace {

constexpr double kGrip = 9;                        // Units of the window, as is:
constexpr double kFineSize = 1.5, kGridSize = 12;  // A step is not shorter, freely and on the grid.
constexpr ImU32 kRest = IM_COL32(76, 148, 240, 255), kOver = IM_COL32(255, 140, 26, 255);

/// Where a number is seen in the world, and the line that it is dragged along.
struct Place {
    glm::dvec3 at{0}, along{0};  ///< The latter of length 1.
    double scale = 1;            ///< World units of a unit of the leaf, along it.
};

Place place_in_world(const ShapeNumber& number, const glm::dmat4& to_world) {
    const glm::dvec3 along = glm::dmat3(to_world) * number.along;
    const double scale = std::max(glm::length(along), 1e-12);
    return {glm::dvec3(to_world * glm::dvec4(number.at, 1)), along / scale, scale};
}

class SizeTool : public Tool {
  public:
    bool hover(ToolContext& context, const std::optional<glm::dvec2>& at) override {
        const auto number = at ? number_at(context, *at) : std::nullopt;
        return std::exchange(over_, number) != number;
    }

    bool press(ToolContext& context, const PointerEvent& event) override {
        const auto number = event.button == Button::Left ? number_at(context, event.position) : std::nullopt;
        if (!number) {
            return false;
        }
        const ShapeNumber& gripped = numbers_[*number];
        const Place place = place_in_world(gripped, to_world_);
        const auto along = along_line(context, place, event.position);
        over_ = number;
        typed_.clear();
        if (along) {
            drag_ = Drag{gripped, place, *along, gripped.value, event.position, context.session.selected_occurrence(),
                         false};
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
            const bool on_grid = context.held(GLFW_KEY_LEFT_CONTROL) || context.held(GLFW_KEY_RIGHT_CONTROL);
            const double least = (on_grid ? kGridSize : kFineSize) * static_cast<double>(context.scale) *
                                 unit_at(context.camera, context.picture, drag_->place.at) / drag_->place.scale;
            const double below = round_number(least), step = below < least ? round_number(2.5 * below) : below;
            const double wanted =
                drag_->number.value + (*now - drag_->gripped) / drag_->place.scale * drag_->number.per_unit;
            drag_->value = std::max(std::round(wanted / step) * step, step);
        }
        set(context);
    }

    void release(ToolContext& /*context*/, const glm::dvec2& /*at*/) override {
        drag_.reset();
        typed_.clear();
    }

    void click(ToolContext& context, const glm::dvec2& at) override {
        context.commands.emplace_back(SelectAt{at - glm::dvec2(context.picture.corner)});
    }

    bool key(ToolContext& context, const KeyEvent& event) override {
        if (!drag_) {
            return false;
        }
        if (ends_drag(event)) {
            drag_.reset();
        } else if (type_number(event, typed_)) {
            set(context);
        } else {
            return event.chord.key != GLFW_KEY_ESCAPE;
        }
        return true;
    }

    bool cancel(ToolContext& context) override {
        if (!drag_) {
            return false;
        }
        drag_->value = drag_->number.value;
        typed_.clear();
        set(context);
        drag_.reset();
        return true;
    }

    void end(ToolContext& context) override {
        over_.reset();
        (void)cancel(context);
    }

    /// "h 12"
    [[nodiscard]] std::string text() const override {
        return drag_ ? fmt::format("{} {}{}", drag_->number.name, value_text(), typed_.empty() ? "" : "_") : "";
    }

    void draw(const ToolContext& context, const ToolPainter& painter) const override {
        look(context);
        const Rectangle& place = context.picture;
        painter.list.PushClipRect({place.corner.x, place.corner.y},
                                  {place.corner.x + place.size.x, place.corner.y + place.size.y});
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            draw_number(context, numbers_[i], drag_ ? drag_->number.name == numbers_[i].name : over_ == i, painter);
        }
        if (drag_) {
            draw_drag_text(text(), drag_->pointer, painter);
        }
        painter.list.PopClipRect();
    }

  private:
    struct Drag {
        ShapeNumber number;  ///< As it was gripped, …
        Place place;
        double gripped = 0;  ///< … there on the line.
        double value = 0;
        glm::dvec2 pointer{0};
        csg::OccurrenceId occurrence = csg::kNoOccurrence;
        bool set = false;  ///< The text has followed.
    };

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
        const csg::LeafId leaf = model ? first_leaf_below(model->scene, selected) : 0;
        if (!model || !model->program || !context.session.can_move() || leaf >= model->scene.leaves.size()) {
            return;
        }
        const csg::LeafInstance& instance = model->scene.leaves[leaf];
        const csg::Node& node = model->tree->node(instance.node);
        if (node.operation != csg::Operation::Leaf || !node.where.known()) {
            return;
        }
        to_world_ = instance.to_world;
        numbers_ = model->program->look([&](const csg::scad::Program& program) -> std::vector<ShapeNumber> {
            csg::SourceLocation where = node.where;
            const bool main = model->tree->files()[where.file] == program.sources[program.units[0].file].name();
            const std::string& text = program.sources[program.units[0].file].text();
            where.file = program.units[0].file;
            const auto call = main && text == context.session.editing().text().text()
                                  ? csg::scad::call_at(program, where)
                                  : std::nullopt;
            return call ? shape_numbers(model->tree->shape(instance.node), *call, text) : std::vector<ShapeNumber>();
        });
    }

    [[nodiscard]] std::optional<std::size_t> number_at(const ToolContext& context, const glm::dvec2& at) const {
        look(context);
        std::optional<std::size_t> nearest;
        double least = kGrip * static_cast<double>(context.scale);
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            const auto seen = place_of(context.camera, context.picture, place_in_world(numbers_[i], to_world_).at);
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

    void set(ToolContext& context) {
        context.commands.emplace_back(SetNumber{drag_->number.bytes, value_text(), !drag_->set, drag_->number.name});
        drag_->set = true;
    }

    void draw_number(const ToolContext& context, const ShapeNumber& number, bool over,
                     const ToolPainter& painter) const {
        const Place place = place_in_world(number, to_world_);
        const double unit = unit_at(context.camera, context.picture, place.at) * static_cast<double>(painter.scale);
        const auto at = place_of(context.camera, context.picture, place.at),
                   tip = place_of(context.camera, context.picture, place.at + 26 * unit * place.along);
        if (!at || !tip) {
            return;
        }
        const ImU32 color = over ? kOver : kRest;
        painter.list.AddLine(window_point(*at), window_point(*tip), IM_COL32(20, 20, 20, 150), 4.5F * painter.scale);
        painter.list.AddLine(window_point(*at), window_point(*tip), color, 2.5F * painter.scale);
        painter.list.AddCircleFilled(window_point(*at), 7 * painter.scale, IM_COL32(20, 20, 20, 150));
        painter.list.AddCircleFilled(window_point(*at), 5.5F * painter.scale, color);
        const ImFont& font = *painter.fonts.bold;
        const std::string label = fmt::format("{} {}", number.name, short_number(number.value, 1e-6 * number.value));
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
    mutable glm::dmat4 to_world_{1.0};          ///< … which lies there.
};

}  // namespace

std::unique_ptr<Tool> make_size_tool() {
    return std::make_unique<SizeTool>();
}

}  // namespace ui
