#include "csg/solid/raw_offset.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "csg/solid/indexed_outline.h"

namespace csg::solid {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// To the right of the way, of length 1.
glm::dvec2 normal_of(const GridPoint& way) {
    const glm::dvec2 normal(static_cast<double>(way.y), -static_cast<double>(way.x));
    return normal / glm::length(normal);
}

struct Corners {
    Loop given;
    std::vector<GridPoint> exact;
};

/// Without those that are nearer than `least` to the one before.
Corners distinct(const Loop& line, bool closed, double least) {
    Corners kept;
    // Not a structured binding: those are not for lambdas in Clang 14.
    Loop& given = kept.given;
    std::vector<GridPoint>& exact = kept.exact;
    const auto repeats = [&](std::size_t i, std::size_t k) {
        return exact[i] == exact[k] || glm::distance(given[i], given[k]) < least;
    };
    const std::vector<GridPoint> all = exact_points(line);
    for (std::size_t i = 0; i < line.size(); ++i) {
        given.push_back(line[i]);
        exact.push_back(all[i]);
        const bool meets = closed && i + 1 == line.size();
        while (given.size() > 1 &&
               (repeats(given.size() - 1, given.size() - 2) || (meets && repeats(given.size() - 1, 0)))) {
            given.pop_back();
            exact.pop_back();
        }
    }
    return kept;
}

}  // namespace

/// From the normal of one edge to that of the next.
struct RawOffset::Bend {
    glm::dvec2 before, after;
    double sine, cosine;

    /// Where the way turns to the left (1), to the right (-1), or not at all, or back (0).
    Bend(const glm::dvec2& first, const glm::dvec2& second, int side)
        : before(first), after(second), sine(first.x * second.y - second.x * first.y), cosine(glm::dot(first, second)) {
        // Rounding may not turn it around.
        sine = side * std::min(std::abs(sine), 1.0);
    }
    [[nodiscard]] double angle() const { return std::atan2(std::abs(sine), cosine); }
};

RawOffset::RawOffset(const Widening& how, double unit) : how_(how), unit_(unit) {
    const double distance = std::abs(how.distance);
    const double tolerance = std::min(how.tolerance, distance / 4);
    steps_ = std::min(std::numbers::pi / std::acos(1 - tolerance / distance), std::numbers::pi * distance / unit);
    least_miter_ = how.miter_limit > 2 ? 2 / (how.miter_limit * how.miter_limit) : 0.5;
}

Loop RawOffset::around(const Loop& line) {
    loop_.clear();
    const bool closed = how_.end == LineEnd::Closed;
    // Miters and squares make large corners of the smallest steps.
    const Corners kept = distinct(line, closed, how_.join == Join::Round ? 0 : unit_);
    const Loop& corners = kept.given;
    const std::vector<GridPoint>& exact = kept.exact;
    // What remains of a region or a hole that is narrower still is as good as a line.
    if (corners.empty() || (closed && corners.size() < 3 && area2(line) * how_.distance <= 0)) {
        return {};
    }
    if (corners.size() == 1) {
        add_dot(corners[0]);
        return std::move(loop_);
    }
    // An open line is a loop, there and back.
    const std::size_t last = corners.size() - 1, edges = closed ? corners.size() : 2 * last;
    const auto corner = [&](std::size_t i) { return i <= last ? i : 2 * last - i; };
    const auto way = [&](std::size_t edge) {
        return closed ? exact[edge < last ? edge + 1 : 0] - exact[edge] : exact[corner(edge + 1)] - exact[corner(edge)];
    };
    GridPoint before = way(edges - 1);
    for (std::size_t edge = 0; edge < edges; ++edge) {
        const GridPoint after = way(edge);
        const glm::dvec2& at = corners[corner(edge)];
        if (!closed && (edge == 0 || edge == last)) {
            add_end(at, normal_of(before));
        } else {
            add_corner(at, Bend(normal_of(before), normal_of(after), sign(cross(before, after))));
        }
        before = after;
    }
    return std::move(loop_);
}

Loop RawOffset::beside(const Loop& line) {
    loop_.clear();
    const auto [corners, exact] = distinct(line, false, how_.join == Join::Round ? 0 : unit_);
    const std::size_t edges = corners.size() - 1;
    std::vector<glm::dvec2> normals;
    for (std::size_t i = 0; i < edges; ++i) {
        normals.push_back(normal_of(exact[i + 1] - exact[i]));
    }
    if (normals.empty()) {
        return {};
    }
    add(corners[0], normals[0]);
    for (std::size_t i = 1; i < edges; ++i) {
        const int side = turn_sign(exact[i - 1], exact[i], exact[i + 1]);
        add_corner(corners[i], Bend(normals[i - 1], normals[i], side));
    }
    add(corners[edges], normals[edges - 1]);
    for (std::size_t i = edges; i-- > 0;) {
        add(corners[i + 1], -0.25 * normals[i]);
        add(corners[i], -0.25 * normals[i]);
        if (i > 0) {
            loop_.push_back(corners[i]);
        }
    }
    return std::move(loop_);
}

void RawOffset::add_corner(const glm::dvec2& corner, const Bend& bend) {
    if (bend.cosine > 0 && std::abs(bend.sine * how_.distance) < unit_) {
        add(corner, bend.before);
        return;
    }
    if (bend.sine * how_.distance < 0) {
        add(corner, bend.before);
        loop_.push_back(corner);
        add(corner, bend.after);
        return;
    }
    if (how_.join == Join::Round) {
        add_arc(corner, bend);
    } else if (how_.join == Join::Miter && 1 + bend.cosine >= least_miter_) {
        // By the tangent of half the angle, in the form that keeps its digits.
        const double along = bend.cosine > 0 ? bend.sine / (1 + bend.cosine) : (1 - bend.cosine) / bend.sine;
        add(corner, bend.before + along * glm::dvec2(-bend.before.y, bend.before.x));
    } else {
        add_square(corner, bend);
    }
}

void RawOffset::add_arc(const glm::dvec2& corner, const Bend& bend) {
    const double steps = std::max(std::floor(steps_ / kTurn * bend.angle() + 0.5), 1.0);
    for (int i = 0; i < steps; ++i) {
        const double angle = (how_.distance < 0 ? -kTurn : kTurn) / steps_ * i;
        const double sine = std::sin(angle), cosine = std::cos(angle);
        add(corner, {cosine * bend.before.x - sine * bend.before.y, sine * bend.before.x + cosine * bend.before.y});
    }
    add(corner, bend.after);
}

/// Cut off so that the middle is as far away as the distance.
void RawOffset::add_square(const glm::dvec2& corner, const Bend& bend) {
    const double along = std::tan(bend.angle() / 4) * (how_.distance < 0 ? -1 : 1);
    add(corner, bend.before + along * glm::dvec2(-bend.before.y, bend.before.x));
    add(corner, bend.after - along * glm::dvec2(-bend.after.y, bend.after.x));
}

void RawOffset::add_end(const glm::dvec2& corner, const glm::dvec2& normal) {
    const Bend back(normal, -normal, 0);
    if (how_.end == LineEnd::Butt) {
        add(corner, normal);
        add(corner, -normal);
    } else if (how_.end == LineEnd::Round) {
        add_arc(corner, back);
    } else {
        add_square(corner, back);
    }
}

void RawOffset::add_dot(const glm::dvec2& center) {
    if (how_.join == Join::Round) {
        for (int i = 0; i < std::floor(steps_); ++i) {
            add(center, {std::cos(kTurn / steps_ * i), std::sin(kTurn / steps_ * i)});
        }
    } else {
        for (const glm::dvec2& way : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
            add(center, way);
        }
    }
    if (how_.distance < 0) {
        std::reverse(loop_.begin(), loop_.end());
    }
}

}  // namespace csg::solid
