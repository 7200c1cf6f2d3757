#include "ui/pipeline/motion/tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace ui {

namespace {

constexpr std::uint32_t kSides = 12;

/// A direction across `along`, of length 1.
glm::dvec3 across(const glm::dvec3& along) {
    const glm::dvec3 a = glm::abs(along);
    const glm::dvec3 axis = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                            : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                     : glm::dvec3(0, 0, 1);
    return glm::normalize(glm::cross(along, axis));
}

/// The direction of the curve at each of its points: half way between the pieces that meet there.
std::vector<glm::dvec3> tangents(std::span<const TubePoint> curve) {
    std::vector<glm::dvec3> result(curve.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const glm::dvec3 way = curve[i + 1].at - curve[i].at;
        if (const double length = glm::length(way); length > 0) {
            result[i] += way / length;
            result[i + 1] += way / length;
        }
    }
    // Of points that repeat, both have the direction of both.
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        if (curve[i].at == curve[i + 1].at) {
            result[i] = result[i + 1] = result[i] + result[i + 1];
        }
    }
    glm::dvec3 last(0, 0, 1);
    for (glm::dvec3& t : result) {
        const double length = glm::length(t);
        last = length > 1e-9 ? t / length : last;
        t = last;
    }
    return result;
}

class TubeMaker {
  public:
    csg::Polyhedron make(std::span<const TubePoint> curve) {
        const std::vector<glm::dvec3> along = tangents(curve);
        glm::dvec3 side = across(along.front());
        for (std::size_t i = 0; i < curve.size(); ++i) {
            // Without a twist: what is left of the side before, across the new direction.
            const glm::dvec3 left = side - glm::dot(side, along[i]) * along[i];
            side = glm::length(left) > 1e-9 ? glm::normalize(left) : across(along[i]);
            add(curve[i], side, glm::cross(along[i], side));
        }
        cap(rings_.back(), false);
        return std::move(mesh_);
    }

  private:
    struct Ring {
        std::uint32_t first = 0;
        bool point = false;
    };

    void add(const TubePoint& p, const glm::dvec3& u, const glm::dvec3& v) {
        Ring ring{static_cast<std::uint32_t>(mesh_.points.size()), p.radius <= 0};
        for (std::uint32_t k = 0; k < (ring.point ? 1 : kSides); ++k) {
            const double angle = 2 * std::numbers::pi * k / kSides;
            mesh_.points.push_back(p.at + p.radius * (std::cos(angle) * u + std::sin(angle) * v));
        }
        if (rings_.empty()) {
            cap(ring, true);
        } else {
            join(rings_.back(), ring);
        }
        rings_.push_back(ring);
    }

    /// Faces are clockwise seen from outside, rings counter-clockwise seen against the curve.
    void join(const Ring& a, const Ring& b) {
        for (std::uint32_t k = 0; k < kSides && !(a.point && b.point); ++k) {
            const std::uint32_t next = (k + 1) % kSides;
            if (a.point) {
                mesh_.faces.push_back({a.first, b.first + k, b.first + next});
            } else if (b.point) {
                mesh_.faces.push_back({a.first + k, b.first, a.first + next});
            } else {
                mesh_.faces.push_back({a.first + k, b.first + k, b.first + next, a.first + next});
            }
        }
    }
    void cap(const Ring& ring, bool begin) {
        if (ring.point) {
            return;
        }
        std::vector<std::uint32_t> face;
        for (std::uint32_t k = 0; k < kSides; ++k) {
            face.push_back(ring.first + (begin ? k : kSides - 1 - k));
        }
        mesh_.faces.push_back(std::move(face));
    }

    csg::Polyhedron mesh_;
    std::vector<Ring> rings_;
};

/// The curve up to `length` from its begin, with a point there.
struct Cut {
    std::vector<glm::dvec3> before, behind;
};
Cut cut_at(std::span<const glm::dvec3> curve, double length) {
    Cut result;
    std::size_t i = 0;
    for (; i + 1 < curve.size(); ++i) {
        result.before.push_back(curve[i]);
        const double piece = glm::distance(curve[i], curve[i + 1]);
        if (piece > length) {
            const glm::dvec3 at = glm::mix(curve[i], curve[i + 1], length / piece);
            result.before.push_back(at);
            result.behind.push_back(at);
            break;
        }
        length -= piece;
    }
    result.behind.insert(result.behind.end(),
                         curve.begin() + static_cast<std::ptrdiff_t>(std::min(i + 1, curve.size())), curve.end());
    if (i + 1 >= curve.size()) {
        result.before.assign(curve.begin(), curve.end());
        result.behind.clear();
    }
    return result;
}

}  // namespace

csg::Polyhedron tube(std::span<const TubePoint> curve) {
    std::vector<TubePoint> kept;
    for (const TubePoint& p : curve) {
        if (kept.empty() || p.at != kept.back().at || p.radius != kept.back().radius) {
            kept.push_back(p);
        }
    }
    const bool somewhere =
        std::any_of(kept.begin(), kept.end(), [&](const TubePoint& p) { return p.at != kept.front().at; });
    return somewhere ? TubeMaker().make(kept) : csg::Polyhedron{};
}

csg::Polyhedron arrow(std::span<const glm::dvec3> curve, double radius) {
    const double length = length_of(curve), head = std::min(7 * radius, length);
    const Cut cut = cut_at(curve, length - head);
    std::vector<TubePoint> points;
    if (head < length) {
        for (const glm::dvec3& p : cut.before) {
            points.push_back({p, radius});
        }
    }
    double left = head;
    for (std::size_t i = 0; i < cut.behind.size(); ++i) {
        left -= i == 0 ? 0 : glm::distance(cut.behind[i - 1], cut.behind[i]);
        points.push_back({cut.behind[i], i + 1 == cut.behind.size() ? 0 : 3 * radius * std::max(left, 0.0) / head});
    }
    return tube(points);
}

std::vector<std::vector<glm::dvec3>> dashes(std::span<const glm::dvec3> curve, double dash, double gap) {
    std::vector<std::vector<glm::dvec3>> result;
    std::vector<glm::dvec3> rest(curve.begin(), curve.end());
    while (rest.size() > 1) {
        Cut cut = cut_at(rest, dash);
        // What is left behind the gap would be no dash: this one goes on to the end.
        if (length_of(cut.behind) < gap + 0.5 * dash) {
            result.push_back(std::move(rest));
            break;
        }
        result.push_back(std::move(cut.before));
        rest = cut_at(cut.behind, gap).behind;
    }
    return result;
}

double length_of(std::span<const glm::dvec3> curve) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        length += glm::distance(curve[i], curve[i + 1]);
    }
    return length;
}

}  // namespace ui
