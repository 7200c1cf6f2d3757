#include "csg/solid/segments.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

#include "csg/tree/degrees.h"

namespace csg::solid {
namespace {

constexpr std::size_t kMostCorners = std::size_t{1} << 20;  // Of a loop, that are made here.
constexpr std::size_t kMostSteps = 256;                     // Heights at which an uneven extrusion is looked at.

/// An edge as its longest on the way up, and how many pieces it has.
struct Edge {
    std::size_t index;
    double length;
    std::size_t pieces = 1;

    /// Between the length of a piece now and after one more division.
    [[nodiscard]] double priority() const { return length / (static_cast<double>(pieces) + 0.5); }
    bool operator<(const Edge& other) const { return priority() < other.priority(); }
};

class Divider {
  public:
    Divider(const LinearExtrude& how, std::size_t slices)
        : how_(how), steps_(std::clamp<std::size_t>(slices, 1, kMostSteps)) {}

    [[nodiscard]] Loop up_to(const Loop& loop, std::size_t corners) const {
        std::vector<std::size_t> pieces(loop.size(), 1);
        std::priority_queue<Edge> edges;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            edges.push({i, longest(loop, i)});
        }
        std::vector<Edge> alike;  // Edges of nearly the same length are divided together, or not at all.
        for (std::size_t count = loop.size(); count < corners;) {
            constexpr double kAlike = 0.999;
            const double first = edges.top().priority();
            if (!(first > 0)) {
                break;
            }
            for (alike.clear(); !edges.empty() && edges.top().priority() >= kAlike * first; edges.pop()) {
                alike.push_back(edges.top());
            }
            if (count + alike.size() > corners) {
                break;
            }
            count += alike.size();
            for (Edge& edge : alike) {
                pieces[edge.index] = ++edge.pieces;
                edges.push(edge);
            }
        }
        return divided(loop, pieces);
    }

    /// Edges no longer than `most`; nothing where that would be `corners` or more.
    [[nodiscard]] Loop by_length(const Loop& loop, double most, std::size_t corners) const {
        std::vector<std::size_t> pieces;
        double sum = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const double count = std::max(1.0, std::ceil(longest(loop, i) / most));
            sum += count;
            if (!(sum < static_cast<double>(corners))) {
                return {};
            }
            pieces.push_back(static_cast<std::size_t>(count));
        }
        return divided(loop, pieces);
    }

  private:
    [[nodiscard]] double longest(const Loop& loop, std::size_t i) const {
        const glm::dvec2 edge = loop[(i + 1) % loop.size()] - loop[i];
        if (how_.scale.x == how_.scale.y) {
            return glm::length(edge) * std::max(how_.scale.x, 1.0);
        }
        double length = 0;
        for (std::size_t step = 0; step <= steps_; ++step) {
            const double t = static_cast<double>(step) / static_cast<double>(steps_);
            const double angle = -how_.twist.value_or(0) * t;
            const double c = cos_degrees(angle), s = sin_degrees(angle);
            const glm::dvec2 turned(c * edge.x - s * edge.y, s * edge.x + c * edge.y);
            length = std::max(length, glm::length(turned * (glm::dvec2(1.0) + (how_.scale - glm::dvec2(1.0)) * t)));
        }
        return length;
    }

    static Loop divided(const Loop& loop, const std::vector<std::size_t>& pieces) {
        Loop result;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()];
            for (std::size_t k = 0; k < pieces[i]; ++k) {
                const double t = static_cast<double>(k) / static_cast<double>(pieces[i]);
                result.push_back((1 - t) * a + t * b);
            }
        }
        return result;
    }

    const LinearExtrude& how_;
    std::size_t steps_;
};

std::size_t count_of(double number) {
    return static_cast<std::size_t>(std::clamp(number, 0.0, static_cast<double>(kMostCorners)));
}

}  // namespace

Outline divide_edges(const Outline& outline, const LinearExtrude& how, std::size_t slices) {
    const Divider divider(how, slices);
    const bool bent = how.twist.value_or(0) != 0 || how.scale.x != how.scale.y;
    const Fineness& f = how.fineness;
    const bool by_count = how.segments.has_value() || f.fn > 0;
    if (!(how.segments ? *how.segments > 0 : bent) || !std::isfinite(f.fn)) {
        return outline;
    }
    const std::size_t most = how.segments ? count_of(*how.segments)
                             : f.fn > 0   ? count_of(f.fn)
                                          : count_of(std::ceil(360 / f.fa));
    Outline result;
    for (const Loop& loop : outline.loops) {
        Loop divided = loop;
        if (loop.size() < most) {
            divided = by_count ? Loop() : divider.by_length(loop, f.fs, most);
            if (divided.empty()) {
                divided = divider.up_to(loop, most);
            }
        }
        result.loops.push_back(std::move(divided));
    }
    return result;
}

}  // namespace csg::solid
