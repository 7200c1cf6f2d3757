#include "tests/outlines/even_odd.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace outlines {
namespace {

using csg::solid::Loop;

struct Edge {
    glm::dvec2 a, b;  ///< a.x < b.x
    [[nodiscard]] double at(double x) const { return a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x)); }
};

std::vector<Edge> edges_of(const std::vector<Loop>& loops) {
    std::vector<Edge> edges;
    for (const Loop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 &p = loop[i], &q = loop[(i + 1) % loop.size()];
            if (p.x != q.x) {
                edges.push_back(p.x < q.x ? Edge{p, q} : Edge{q, p});
            }
        }
    }
    return edges;
}

}  // namespace

Moments even_odd_moments(const std::vector<Loop>& loops) {
    const std::vector<Edge> edges = edges_of(loops);
    std::vector<double> cuts;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        cuts.insert(cuts.end(), {edges[i].a.x, edges[i].b.x});
        for (std::size_t k = 0; k < i; ++k) {
            const double lo = std::max(edges[i].a.x, edges[k].a.x), hi = std::min(edges[i].b.x, edges[k].b.x);
            if (lo >= hi) {
                continue;
            }
            const double left = edges[i].at(lo) - edges[k].at(lo), right = edges[i].at(hi) - edges[k].at(hi);
            if (left * right < 0) {
                cuts.push_back(lo + (hi - lo) * (left / (left - right)));
            }
        }
    }
    std::sort(cuts.begin(), cuts.end());
    Moments sum;
    struct Crossing {
        double middle, left, right;
    };
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double lo = cuts[i], hi = cuts[i + 1], width = hi - lo;
        if (!(width > 0)) {
            continue;
        }
        crossings.clear();
        for (const Edge& e : edges) {
            if (e.a.x <= lo && e.b.x >= hi) {
                crossings.push_back({e.at(0.5 * (lo + hi)), e.at(lo), e.at(hi)});
            }
        }
        std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.middle < b.middle; });
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
            const double left = crossings[k + 1].left - crossings[k].left;
            const double right = crossings[k + 1].right - crossings[k].right;
            sum.area += 0.5 * width * (left + right);
            sum.x += width * (lo * 0.5 * (left + right) + width * (left + 2 * right) / 6);
        }
    }
    return sum;
}

double distance_to_edges(const std::vector<Loop>& loops, const glm::dvec2& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Loop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 &a = loop[i], way = loop[(i + 1) % loop.size()] - a;
            const double length = glm::dot(way, way);
            const double t = length > 0 ? std::clamp(glm::dot(p - a, way) / length, 0.0, 1.0) : 0.0;
            least = std::min(least, glm::length(p - (a + t * way)));
        }
    }
    return least;
}

std::optional<bool> is_inside(const std::vector<Loop>& loops, const glm::dvec2& p, double margin) {
    if (distance_to_edges(loops, p) < margin) {
        return {};
    }
    bool inside = false;
    for (const Loop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
            if ((a.y > p.y) != (b.y > p.y) && (csg::solid::turn(a, b, p) > 0) == (b.y > a.y)) {
                inside = !inside;
            }
        }
    }
    return inside;
}

}  // namespace outlines
