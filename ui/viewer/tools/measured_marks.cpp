#include "ui/viewer/tools/measured_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "ui/viewer/picture_places.h"
#include "ui/viewer/window_point.h"

namespace ui {

namespace {

constexpr int kSides = 64;  // Of a circle.
constexpr ImU32 kDark = IM_COL32(20, 20, 20, 200);

/// Two directions across an axis.
std::pair<glm::dvec3, glm::dvec3> across(const glm::dvec3& axis) {
    const glm::dvec3 other = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 first = glm::normalize(glm::cross(axis, other));
    return {first, glm::cross(axis, first)};
}

glm::dvec3 nearest_of(const Measured& thing, const glm::dvec3& to) {
    if (thing.kind == Measured::Kind::Edge) {
        const glm::dvec3 way = thing.to - thing.from;
        return thing.from + std::clamp(glm::dot(to - thing.from, way) / glm::dot(way, way), 0.0, 1.0) * way;
    }
    if (thing.kind == Measured::Kind::Circle) {
        const glm::dvec3 out = to - thing.form.point;
        const glm::dvec3 flat = out - glm::dot(out, thing.form.direction) * thing.form.direction;
        return glm::length(flat) > 0 ? thing.form.point + thing.form.radius * glm::normalize(flat) : to;
    }
    return thing.at;
}

}  // namespace

double distance_on_screen(const base::Camera& camera, const Rectangle& picture, const Measured& thing,
                          const glm::dvec3& near, const glm::dvec2& at) {
    const auto place = place_of(camera, picture, nearest_of(thing, near));
    return place ? glm::distance(*place, at) : std::numeric_limits<double>::infinity();
}

void MeasuredMarks::line(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float width) const {
    const auto a = place_of(camera, picture, from), b = place_of(camera, picture, to);
    if (a && b) {
        painter.list.AddLine(window_point(*a), window_point(*b), color, width * painter.scale);
    }
}

void MeasuredMarks::ring(const glm::dvec3& center, const glm::dvec3& axis, double radius, ImU32 color) const {
    const auto [u, v] = across(axis);
    const auto on = [&, u = u, v = v](int i) {
        const double angle = i * 2 * glm::pi<double>() / kSides;
        return center + radius * (std::cos(angle) * u + std::sin(angle) * v);
    };
    for (int i = 0; i < kSides; ++i) {
        line(on(i), on(i + 1), color, 2);
    }
}

void MeasuredMarks::dot(const glm::dvec3& at, ImU32 color, bool filled) const {
    const auto place = place_of(camera, picture, at);
    if (!place) {
        return;
    }
    if (filled) {
        painter.list.AddCircleFilled(window_point(*place), 5 * painter.scale, kDark);
        painter.list.AddCircleFilled(window_point(*place), 3.5F * painter.scale, color);
    } else {
        painter.list.AddCircle(window_point(*place), 6 * painter.scale, kDark, 0, 4 * painter.scale);
        painter.list.AddCircle(window_point(*place), 6 * painter.scale, color, 0, 2 * painter.scale);
    }
}

void MeasuredMarks::thing(const Measured& thing, ImU32 color) const {
    using csg::solid::FormKind;
    switch (thing.kind) {
        case Measured::Kind::Point:
            dot(thing.at, color, false);
            return;
        case Measured::Kind::Edge:
            line(thing.from, thing.to, kDark, 5);
            line(thing.from, thing.to, color, 3);
            return;
        case Measured::Kind::Circle:
            ring(thing.form.point, thing.form.direction, thing.form.radius, color);
            return;
        case Measured::Kind::Face:
            break;
    }
    if (thing.form.kind == FormKind::Plane) {
        const double arm = 28 * static_cast<double>(painter.scale) * unit_at(camera, picture, thing.at);
        line(thing.at, thing.at + arm * thing.form.direction, color, 2);
    } else if (thing.form.kind == FormKind::Cylinder) {
        const glm::dvec3 on_axis =
            thing.form.point + glm::dot(thing.at - thing.form.point, thing.form.direction) * thing.form.direction;
        ring(on_axis, thing.form.direction, thing.form.radius, color);
        line(on_axis - thing.form.radius * thing.form.direction, on_axis + thing.form.radius * thing.form.direction,
             color, 1);
    } else if (thing.form.kind == FormKind::Sphere) {
        dot(thing.form.point, color, false);
    }
    dot(thing.at, color, true);
}

void MeasuredMarks::distance(const Relation& relation) const {
    const auto a = place_of(camera, picture, relation.from), b = place_of(camera, picture, relation.to);
    if (!relation.distance || !a || !b) {
        return;
    }
    line(relation.from, relation.to, kDark, 4);
    line(relation.from, relation.to, IM_COL32(255, 255, 255, 255), 2);
    const std::string text = fmt::format("{:.6g}", *relation.distance);
    const ImFont& font = *painter.fonts.bold;
    const ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, text.c_str());
    const ImVec2 at = window_point(0.5 * (*a + *b));
    const float pad = 4 * painter.scale;
    const ImVec2 low{at.x + 2 * pad, at.y - 0.5F * size.y};
    painter.list.AddRectFilled({low.x - pad, low.y - pad / 2}, {low.x + size.x + pad, low.y + size.y + pad / 2},
                               IM_COL32(20, 22, 26, 230), pad);
    painter.list.AddText(&font, font.FontSize, low, IM_COL32_WHITE, text.c_str());
}

void MeasuredMarks::box(const csg::Box& box, ImU32 color) const {
    for (int axis = 0; axis < 3; ++axis) {
        for (int corner = 0; corner < 4; ++corner) {
            glm::dvec3 from = box.lo;
            from[(axis + 1) % 3] = (corner & 1) != 0 ? box.hi[(axis + 1) % 3] : box.lo[(axis + 1) % 3];
            from[(axis + 2) % 3] = (corner & 2) != 0 ? box.hi[(axis + 2) % 3] : box.lo[(axis + 2) % 3];
            glm::dvec3 to = from;
            to[axis] = box.hi[axis];
            line(from, to, color, 1);
        }
    }
}

void MeasuredMarks::note(const std::string& text) const {
    if (text.empty()) {
        return;
    }
    const ImFont& font = *painter.fonts.text;
    const float pad = 8 * painter.scale, wrap = std::max(picture.size.x * 0.6F, 100.0F);
    const ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, wrap, text.c_str());
    const ImVec2 low{picture.corner.x + pad, picture.corner.y + pad};
    painter.list.AddRectFilled(low, {low.x + size.x + 2 * pad, low.y + size.y + 2 * pad}, IM_COL32(32, 35, 40, 225),
                               pad / 2);
    painter.list.AddText(&font, font.FontSize, {low.x + pad, low.y + pad}, IM_COL32(225, 227, 232, 255), text.c_str(),
                         nullptr, wrap);
}

}  // namespace ui
