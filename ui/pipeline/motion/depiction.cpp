#include "ui/pipeline/motion/depiction.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "csg/tree/additions.h"
#include "ui/pipeline/motion/box_corners.h"
#include "ui/pipeline/motion/character.h"
#include "ui/pipeline/motion/rigid_motion.h"
#include "ui/pipeline/motion/tube.h"
#include "ui/pipeline/suggestion.h"

namespace ui {

namespace {

using Technique = Depiction::Technique;

constexpr csg::Rgba kPast{0.85F, 0.2F, 0.15F, 1}, kLines{0.25F, 0.25F, 0.3F, 1}, kGhost{0.55F, 0.6F, 0.7F, 1};
/// Of the model's diagonal: the radius of arrows, and how near points of curves are to each other.
constexpr double kRadius = 0.004, kStep = 0.01;
constexpr int kMostPoints = 2000;

/// Where a body is at any time of the motion.
class Course {
  public:
    Course(const Motion& motion, const MovingBody& body) : motion_(motion), body_(body) {}

    /// None where it is not there.
    [[nodiscard]] std::optional<glm::dmat4> at(double time) const {
        const auto next = std::upper_bound(motion_.times.begin(), motion_.times.end(), time);
        const auto i = static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(next - motion_.times.begin() - 1, 0, std::ssize(motion_.times) - 1));
        const std::size_t j = std::min(i + 1, motion_.times.size() - 1);
        const auto &a = body_.poses[i], &b = body_.poses[j];
        if (!a || !b || i == j) {
            return a                               ? std::optional(a->motion)
                   : b && time >= motion_.times[j] ? std::optional(b->motion)
                                                   : std::nullopt;
        }
        return between(a->motion, b->motion, (time - motion_.times[i]) / (motion_.times[j] - motion_.times[i]));
    }

    /// The way of a point, as it was at first, while the time runs, with `most` the longest piece; in parts where the
    /// body is away or jumps in between.
    [[nodiscard]] std::vector<std::vector<glm::dvec3>> way(const glm::dvec3& point, double from, double to,
                                                           double most) const {
        std::vector<std::vector<glm::dvec3>> parts(1);
        const auto begin_part = [&] {
            if (!parts.back().empty()) {
                parts.emplace_back();
            }
        };
        std::vector<double> times{from};
        for (const double t : motion_.times) {
            if (t > from && t < to) {
                times.push_back(t);
            }
        }
        times.push_back(to);
        for (std::size_t i = 0; i < times.size(); ++i) {
            const auto here = at(times[i]);
            if (!here) {
                begin_part();
                continue;
            }
            const glm::dvec3 p(*here * glm::dvec4(point, 1));
            if (!parts.back().empty() && i > 0 && jumps(times[i - 1], times[i])) {
                begin_part();
            }
            if (!parts.back().empty()) {
                // Along the screw from sample to sample.
                const auto before = at(times[i - 1]);
                const double length = arc(*before, *here, point);
                const int pieces = static_cast<int>(std::clamp(std::ceil(length / most), 1.0, double{kMostPoints}));
                for (int k = 1; k < pieces; ++k) {
                    parts.back().emplace_back(between(*before, *here, double{1} * k / pieces) * glm::dvec4(point, 1));
                }
            }
            parts.back().push_back(p);
        }
        std::erase_if(parts, [](const auto& part) { return length_of(part) == 0; });
        return parts;
    }

    [[nodiscard]] const MovingBody& body() const { return body_; }

  private:
    [[nodiscard]] bool jumps(double from, double to) const {
        return std::any_of(body_.events.begin(), body_.events.end(), [&](const MotionEvent& event) {
            return event.kind == MotionEvent::Kind::Jumps && event.after >= from && event.before <= to;
        });
    }
    static double arc(const glm::dmat4& a, const glm::dmat4& b, const glm::dvec3& point) {
        double length = 0;
        glm::dvec3 before(a * glm::dvec4(point, 1));
        for (int k = 1; k <= 8; ++k) {
            const glm::dvec3 next(between(a, b, k / 8.0) * glm::dvec4(point, 1));
            length += glm::distance(before, next);
            before = next;
        }
        return length;
    }

    const Motion& motion_;
    const MovingBody& body_;
};

glm::dvec3 center_of(const csg::Box& box) {
    return 0.5 * (box.lo + box.hi);
}

class Depicter {
  public:
    Depicter(const csg::Tree& model, const Motion& motion, double now) : model_(model), motion_(motion), now_(now) {
        csg::Box all;
        for (const MovingBody& body : motion.bodies) {
            for (const auto& pose : body.poses) {
                if (pose && !body.box.empty()) {
                    for (const glm::dvec3& corner : corners_of(body.box)) {
                        all = csg::enclose(all, glm::dvec3(pose->motion * glm::dvec4(corner, 1)));
                    }
                }
            }
        }
        size_ = std::max(all.diagonal(), 1e-300);
    }

    void add(const Depiction& d) {
        for (const MovingBody* body : bodies(d)) {
            try {
                d.technique == Technique::Auto ? choose(d, *body) : draw(d, d.technique, *body);
            } catch (const std::runtime_error& problem) {
                throw std::runtime_error(fmt::format("{}: {}", d.text, problem.what()));
            }
        }
    }

    csg::Tree finish() { return csg::with_additions(model_, additions_); }

  private:
    /// "wheel" names wheel, wheel 2, …; "wheel 2" that one.
    [[nodiscard]] std::vector<const MovingBody*> bodies(const Depiction& d) const {
        std::vector<const MovingBody*> found;
        std::vector<std::string> names;
        for (const MovingBody& body : motion_.bodies) {
            const bool one_of = body.name.starts_with(d.part + " ") &&
                                body.name.find_first_not_of("0123456789", d.part.size() + 1) == std::string::npos;
            if (d.part == "*" || body.name == d.part || one_of) {
                found.push_back(&body);
            }
            names.push_back(body.name);
        }
        if (found.empty()) {
            throw std::runtime_error(
                motion_.bodies.empty() ? fmt::format("{}: nothing moves while $t runs", d.text)
                                       : fmt::format("{}: nothing that moves is called {}{}", d.text, d.part,
                                                     suggestion(d.part, names, "; csgscope motion lists what does.")));
        }
        return found;
    }

    void choose(const Depiction& d, const MovingBody& body) {
        switch (character_of(motion_, body).kind) {
            case Character::Kind::Turns:
                draw(d, Technique::Rotation, body);
                break;
            case Character::Kind::Screws:
                draw(d, Technique::Rotation, body);
                draw(d, Technique::Path, body);
                break;
            case Character::Kind::Slides:
            case Character::Kind::Travels:
            case Character::Kind::Moves:
                draw(d, Technique::Ghost, body);
                draw(d, Technique::Path, body);
                break;
            case Character::Kind::Stays:
            case Character::Kind::Deforms:
                break;
        }
    }

    void draw(const Depiction& d, Technique technique, const MovingBody& body) {
        const auto [from, to] = d.times.value_or(std::pair(motion_.times.front(), motion_.times.back()));
        const Course course(motion_, body);
        const double radius = d.width ? 0.5 * *d.width : kRadius * size_;
        switch (technique) {
            case Technique::Path:
                draw_path(course, from, to, radius, d.color.value_or(kPast));
                break;
            case Technique::Motion:
                draw_lines(course, d, from, to, radius);
                break;
            case Technique::Still:
            case Technique::Ghost:
                draw_images(course, d, technique == Technique::Ghost, from, to);
                break;
            case Technique::Rotation:
                draw_rotation(body, radius, d.color.value_or(kPast));
                break;
            case Technique::Auto:
                break;
        }
    }

    void add_shape(csg::Polyhedron mesh, const csg::Rgba& color) {
        if (!mesh.faces.empty()) {
            additions_.push_back({std::make_shared<const csg::Polyhedron>(std::move(mesh)), nullptr, csg::kNoNode,
                                  glm::dmat4(1.0), color});
        }
    }

    void draw_path(const Course& course, double from, double to, double radius, const csg::Rgba& color) {
        const glm::dvec3 middle = center_of(course.body().box);
        bool drawn = false;
        for (const bool future : {false, true}) {
            const double first = future ? std::max(from, now_) : from, last = future ? to : std::min(to, now_);
            if (!(first < last)) {
                continue;
            }
            for (const auto& part : course.way(middle, first, last, kStep * size_)) {
                if (length_of(part) < 2 * radius) {
                    continue;
                }
                drawn = true;
                if (!future) {
                    add_shape(last < to ? plain(part, radius) : arrow(part, radius), color);
                    continue;
                }
                const auto pieces = dashes(part, 8 * radius, 5 * radius);
                for (std::size_t i = 0; i < pieces.size(); ++i) {
                    add_shape(i + 1 < pieces.size() ? plain(pieces[i], radius) : arrow(pieces[i], radius), color);
                }
            }
        }
        if (!drawn) {
            throw std::runtime_error(
                fmt::format("the middle of {} stays where it is; rotation shows what turns", course.body().name));
        }
    }

    static csg::Polyhedron plain(std::span<const glm::dvec3> curve, double radius) {
        std::vector<TubePoint> points;
        for (const glm::dvec3& p : curve) {
            points.push_back({p, radius});
        }
        return tube(points);
    }

    /// From points at the outline against the motion, the longer the faster it is, thinner and thinner.
    void draw_lines(const Course& course, const Depiction& d, double from, double to, double radius) {
        const double h = 1e-3 * (motion_.times.back() - motion_.times.front());
        const auto here = course.at(to), before = course.at(to - h);
        if (!here || !before) {
            throw std::runtime_error(fmt::format("{} is not there at $t = {:.6g}", course.body().name, to));
        }
        const std::vector<glm::dvec3>& extremes = course.body().extremes;
        const glm::dvec4 middle(center_of(course.body().box), 1);
        const glm::dvec3 velocity(*here * middle - *before * middle);
        if (extremes.empty() || glm::length(velocity) < 1e-9 * size_) {
            throw std::runtime_error(fmt::format("{} is at rest at $t = {:.6g}", course.body().name, to));
        }
        const glm::dvec3 ahead = glm::normalize(velocity);
        const glm::dvec3 u = perpendicular(ahead), v = glm::cross(ahead, u);
        for (int k = 0; k < d.count; ++k) {
            const double angle = 2 * std::numbers::pi * k / d.count;
            const glm::dvec3 aside = std::cos(angle) * u + std::sin(angle) * v;
            const glm::dvec3* best = &extremes.front();
            double reach = -INFINITY;
            for (const glm::dvec3& p : extremes) {
                const glm::dvec3 placed(*here * glm::dvec4(p, 1));
                if (const double far = glm::dot(placed, aside - 0.3 * ahead); far > reach) {
                    reach = far;
                    best = &p;
                }
            }
            for (const auto& part : course.way(*best, from, to, kStep * size_)) {
                std::vector<TubePoint> points;
                const double length = length_of(part);
                double so_far = 0;
                for (std::size_t i = 0; i < part.size(); ++i) {
                    so_far += i == 0 ? 0 : glm::distance(part[i - 1], part[i]);
                    points.push_back({part[i], 0.8 * radius * so_far / length});
                }
                add_shape(tube(points), d.color.value_or(kLines));
            }
        }
    }

    static glm::dvec3 perpendicular(const glm::dvec3& d) {
        return glm::normalize(glm::cross(d, std::abs(d.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0)));
    }

    void draw_images(const Course& course, const Depiction& d, bool several, double from, double to) {
        const MovingBody& body = course.body();
        if (body.changes_shape) {
            throw std::runtime_error(fmt::format("{} changes its shape, of which there are no images", body.name));
        }
        const int count = several && from < to ? d.count : 1;
        const double fastest = character_of(motion_, body).fastest;
        for (int i = 0; i < count; ++i) {
            const double time = count == 1 ? (several ? from : to) : from + (to - from) * i / (count - 1);
            const auto pose = course.at(time);
            // Where the model itself stands there is nothing to add.
            if (!pose || (several && std::abs(time - now_) < 1e-9 * (motion_.times.back() - motion_.times.front()))) {
                continue;
            }
            csg::Rgba color = d.color ? *d.color : body.color.given() ? body.color : kGhost;
            if (several) {
                const double span = std::max({std::abs(from - now_), std::abs(to - now_), 1e-300});
                color.a = static_cast<float>(0.5 - 0.35 * std::abs(time - now_) / span);
            }
            const glm::dmat4 placed = *pose * body.to_world;
            const glm::dmat4 shown = d.squash > 0 ? squashed(course, time, d.squash, fastest) * placed : placed;
            additions_.push_back({{}, body.tree.get(), body.top, shown, color});
        }
    }

    /// Stretched along the way by its share of the highest speed, as much thinner across it.
    [[nodiscard]] glm::dmat4 squashed(const Course& course, double time, double most, double fastest) const {
        const double h = 1e-3 * (motion_.times.back() - motion_.times.front());
        const double first = std::max(time - h, motion_.times.front()), last = std::min(time + h, motion_.times.back());
        const auto a = course.at(first), b = course.at(last), here = course.at(time);
        const glm::dvec4 middle(center_of(course.body().box), 1);
        if (!a || !b || !here || fastest <= 0) {
            return glm::dmat4(1.0);
        }
        const glm::dvec3 way(*b * middle - *a * middle);
        const double speed = glm::length(way) / (last - first);
        if (speed <= 0) {
            return glm::dmat4(1.0);
        }
        const glm::dvec3 ahead = glm::normalize(way), at(*here * middle);
        const double along = 1 + most * std::min(1.0, speed / fastest), aside = 1 / std::sqrt(along);
        glm::dmat3 m(aside);
        m += (along - aside) * glm::outerProduct(ahead, ahead);
        glm::dmat4 result(m);
        result[3] = glm::dvec4(at - m * at, 1);
        return result;
    }

    /// Beyond its farthest reach, from there as far as it turns; with a head at either end where it turns back.
    void draw_rotation(const MovingBody& body, double radius, const csg::Rgba& color) {
        const Character c = character_of(motion_, body);
        if (c.kind != Character::Kind::Turns && c.kind != Character::Kind::Screws) {
            throw std::runtime_error(fmt::format("{} does not turn about one axis", body.name));
        }
        double reach = 0, low = INFINITY, high = -INFINITY;
        glm::dvec3 outwards = perpendicular(c.axis);
        for (const glm::dvec3& p : body.extremes) {
            const double along = glm::dot(p - c.point, c.axis);
            const glm::dvec3 aside = p - c.point - along * c.axis;
            low = std::min(low, along);
            high = std::max(high, along);
            if (glm::length(aside) > reach * (1 + 1e-9)) {
                reach = glm::length(aside);
                outwards = aside / reach;
            }
        }
        constexpr double kMost = 1.7 * std::numbers::pi;  // So that the ends of whole turns are apart.
        const bool back = c.turned_net < 0;
        double from = back ? c.turned_most : c.turned_least, to = back ? c.turned_least : c.turned_most;
        if (std::abs(to - from) > kMost) {
            to = from + std::copysign(kMost, to - from);
        }
        const glm::dvec3 aside = glm::cross(c.axis, outwards), middle = c.point + 0.5 * (low + high) * c.axis;
        const double r = 1.08 * reach + 3 * radius;
        const auto arc = [&](double first, double last) {
            std::vector<glm::dvec3> points;
            const int pieces = std::max(4, static_cast<int>(std::abs(last - first) / 0.06));
            for (int i = 0; i <= pieces; ++i) {
                const double a = first + (last - first) * i / pieces;
                points.push_back(middle + r * (std::cos(a) * outwards + std::sin(a) * aside));
            }
            return arrow(points, radius);
        };
        if (std::abs(c.turned_net) < 0.5 * (c.turned_most - c.turned_least)) {
            add_shape(arc(0.5 * (from + to), from), color);
            from = 0.5 * (from + to);
        }
        add_shape(arc(from, to), color);
    }

    const csg::Tree& model_;
    const Motion& motion_;
    double now_, size_ = 0;
    std::vector<csg::Addition> additions_;
};

}  // namespace

csg::Tree depict(const csg::Tree& model, const Motion& motion, const std::vector<Depiction>& depictions, double now) {
    Depicter depicter(model, motion, now);
    for (const Depiction& d : depictions) {
        depicter.add(d);
    }
    return depicter.finish();
}

}  // namespace ui
