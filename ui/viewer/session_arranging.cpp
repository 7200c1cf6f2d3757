// What is selected is mirrored, repeated, grouped, marked: calls that are put before its statement or around it.
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ui/pipeline/editing/added_shape.h"
#include "ui/pipeline/editing/statement_edits.h"
#include "ui/viewer/session.h"

namespace ui {

namespace {

constexpr int kInRow = 3, kInCircle = 6;
constexpr double kRowGap = 0.25;  ///< Of its size, at least.

std::optional<int> mirrored_axis(Action action) {
    const int axis = static_cast<int>(action) - static_cast<int>(Action::MirrorX);
    return axis >= 0 && axis < 3 ? std::optional(axis) : std::nullopt;
}

std::optional<int> row_axis(Action action) {
    const int axis = static_cast<int>(action) - static_cast<int>(Action::RowX);
    return axis >= 0 && axis < 3 ? std::optional(axis) : std::nullopt;
}

std::optional<std::string_view> operation_for(Action action) {
    switch (action) {
        case Action::MakeUnion:
            return "union";
        case Action::MakeDifference:
            return "difference";
        case Action::MakeIntersection:
            return "intersection";
        case Action::MakeHull:
            return "hull";
        case Action::MakeMinkowski:
            return "minkowski";
        default:
            return std::nullopt;
    }
}

std::optional<char> modifier_for(Action action) {
    switch (action) {
        case Action::MarkHighlight:
            return '#';
        case Action::MarkBackground:
            return '%';
        case Action::MarkOnly:
            return '!';
        case Action::MarkDisabled:
            return '*';
        default:
            return std::nullopt;
    }
}

/// A vector with one coordinate that is not zero.
std::string along_axis(int axis, const std::string& value) {
    return fmt::format("[{}, {}, {}]", axis == 0 ? value : "0", axis == 1 ? value : "0", axis == 2 ? value : "0");
}

/// The box after a map, of its corners.
csg::Box moved_box(const csg::Box& box, const glm::dmat4& map) {
    csg::Box moved;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner((i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
                                (i & 4) != 0 ? box.hi.z : box.lo.z);
        const glm::dvec3 at(map * glm::dvec4(corner, 1.0));
        moved = csg::enclose(moved, {at, at});
    }
    return moved;
}

/// Through the middle of the box, in the coordinates where the statement stands.
std::string mirror_calls(int axis, const csg::Box& box) {
    const double twice = box.lo[axis] + box.hi[axis];
    const std::string mirror = "mirror(" + along_axis(axis, "1") + ") ";
    const double tolerance = 1e-6 * (1 + std::abs(twice));
    return std::abs(twice) <= tolerance
               ? mirror
               : "translate(" + along_axis(axis, short_number(twice, tolerance)) + ") " + mirror;
}

std::string row_calls(int axis, const csg::Box& box, const std::string& variable) {
    const double size = std::max(box.hi[axis] - box.lo[axis], 1e-3);
    const double unit = round_number(size / 10);
    const std::string step = short_number(std::ceil((1 + kRowGap) * size / unit) * unit, 1e-9 * size);
    return fmt::format("for ({} = [0 : {}]) translate({}) ", variable, kInRow - 1,
                       along_axis(axis, fmt::format("{} * {}", step, variable)));
}

std::string circle_calls(const std::string& variable) {
    return fmt::format("for ({0} = [0 : {1}]) rotate([0, 0, {2} * {0}]) ", variable, kInCircle - 1, 360 / kInCircle);
}

}  // namespace

bool Session::arrange(Action action) {
    if (action < Action::MirrorX || action > Action::MarkDisabled) {
        return false;
    }
    const auto statement = selected_statement();
    if (!statement) {
        document_.add_message(LineKind::Warning, "WARNING: select something of this file first");
        return true;
    }
    TextDocument& document = editing_.text();
    const std::string& text = document.text();
    const csg::Box box = moved_box(box_below(*document_.model(), selected_), into_statement(*statement));
    std::optional<StatementEdit> edit;
    std::string what;
    if (const auto mirrored = mirrored_axis(action)) {
        edit = put_before_statement(*statement, mirror_calls(*mirrored, box));
        what = "mirror";
    } else if (const auto row = row_axis(action)) {
        edit = put_before_statement(*statement, row_calls(*row, box, loop_variable(text, *statement)));
        what = "row";
    } else if (action == Action::CircleZ) {
        edit = put_before_statement(*statement, circle_calls(loop_variable(text, *statement)));
        what = "circle";
    } else if (action == Action::Group) {
        edit = group_statement(text, *statement, "union()");
        what = "group";
    } else if (action == Action::Ungroup) {
        edit = ungroup_statement(text, *statement);
        what = "ungroup";
    } else if (const auto operation = operation_for(action)) {
        edit = change_operation(text, *statement, *operation);
        what = "make it a " + std::string(*operation);
    } else if (const auto modifier = modifier_for(action)) {
        edit = toggle_modifier(text, *statement, *modifier);
        what = std::string("mark with ") + *modifier;
    }
    if (!edit) {
        document_.add_message(LineKind::Warning,
                              "WARNING: select a union(), difference(), intersection(), hull() or minkowski() with "
                              "braces, in the text or the tree");
        return true;
    }
    document.edit({std::move(edit->edit)}, what);
    select_next_ = SelectNext{0, 0, 0, {}, edit->added};
    follow_text();
    return true;
}

}  // namespace ui
