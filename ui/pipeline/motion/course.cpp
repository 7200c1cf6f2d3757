#include "ui/pipeline/motion/course.h"

#include <algorithm>
#include <cmath>

#include "ui/pipeline/motion/rigid_motion.h"
#include "ui/pipeline/motion/tube.h"

namespace ui {

namespace {

constexpr int kMostPoints = 2000;

double arc(const glm::dmat4& a, const glm::dmat4& b, const glm::dvec3& point) {
    double length = 0;
    glm::dvec3 before(a * glm::dvec4(point, 1));
    for (int k = 1; k <= 8; ++k) {
        const glm::dvec3 next(between(a, b, k / 8.0) * glm::dvec4(point, 1));
        length += glm::distance(before, next);
        before = next;
    }
    return length;
}

}  // namespace

std::optional<glm::dmat4> Course::at(double time) const {
    const auto next = std::upper_bound(motion_.times.begin(), motion_.times.end(), time);
    const auto i = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(next - motion_.times.begin() - 1, 0, std::ssize(motion_.times) - 1));
    const std::size_t j = std::min(i + 1, motion_.times.size() - 1);
    const auto &a = body_.poses[i], &b = body_.poses[j];
    if (!a || !b || i == j) {
        return a ? std::optional(a->motion) : b && time >= motion_.times[j] ? std::optional(b->motion) : std::nullopt;
    }
    return between(a->motion, b->motion, (time - motion_.times[i]) / (motion_.times[j] - motion_.times[i]));
}

std::vector<std::vector<glm::dvec3>> Course::way(const glm::dvec3& point, double from, double to, double most) const {
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

bool Course::jumps(double from, double to) const {
    return std::any_of(body_.events.begin(), body_.events.end(), [&](const MotionEvent& event) {
        return event.kind == MotionEvent::Kind::Jumps && event.after >= from && event.before <= to;
    });
}

}  // namespace ui
