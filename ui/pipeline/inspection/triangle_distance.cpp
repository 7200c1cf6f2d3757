#include "ui/pipeline/inspection/triangle_distance.h"

#include <algorithm>
#include <optional>

namespace ui {

namespace {

glm::dvec3 nearest_on_triangle(const glm::dvec3& p, const Corners& t) {
    const glm::dvec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) {
        return t[0];
    }
    const glm::dvec3 bp = p - t[1];
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) {
        return t[1];
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        return t[0] + d1 / (d1 - d3) * ab;
    }
    const glm::dvec3 cp = p - t[2];
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) {
        return t[2];
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        return t[0] + d2 / (d2 - d6) * ac;
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        return t[1] + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1]);
    }
    const double all = va + vb + vc;
    return t[0] + vb / all * ab + vc / all * ac;
}

Nearest nearest_of_segments(const glm::dvec3& p, const glm::dvec3& to_p, const glm::dvec3& q, const glm::dvec3& to_q) {
    const glm::dvec3 u = to_p - p, v = to_q - q, w = p - q;
    const double a = glm::dot(u, u), e = glm::dot(v, v), f = glm::dot(v, w);
    double s = 0, t = 0;
    if (a > 0 && e > 0) {
        const double b = glm::dot(u, v), c = glm::dot(u, w), det = a * e - b * b;
        s = det > 1e-14 * a * e ? std::clamp((b * f - c * e) / det, 0.0, 1.0) : 0.0;
        t = (b * s + f) / e;
        if (t < 0 || t > 1) {
            t = std::clamp(t, 0.0, 1.0);
            s = std::clamp((b * t - c) / a, 0.0, 1.0);
        }
    } else if (e > 0) {
        t = std::clamp(f / e, 0.0, 1.0);
    } else if (a > 0) {
        s = std::clamp(-glm::dot(u, w) / a, 0.0, 1.0);
    }
    const glm::dvec3 on_p = p + s * u, on_q = q + t * v;
    return {glm::length(on_p - on_q), on_p, on_q};
}

/// Where the edge goes through the triangle.
std::optional<glm::dvec3> meeting_point(const glm::dvec3& p, const glm::dvec3& q, const Corners& t) {
    const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double from = glm::dot(n, p - t[0]), to = glm::dot(n, q - t[0]);
    if (from * to > 0 || from == to) {
        return std::nullopt;
    }
    const glm::dvec3 at = p + from / (from - to) * (q - p);
    for (std::size_t i = 0; i < 3; ++i) {
        if (glm::dot(n, glm::cross(t[(i + 1) % 3] - t[i], at - t[i])) < 0) {
            return std::nullopt;
        }
    }
    return at;
}

}  // namespace

Nearest nearest_points(const Corners& a, const Corners& b) {
    Nearest best{glm::length(a[0] - b[0]), a[0], b[0]};
    const auto take = [&](const Nearest& other) {
        if (other.distance < best.distance) {
            best = other;
        }
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t after = (i + 1) % 3;
        for (std::size_t j = 0; j < 3; ++j) {
            take(nearest_of_segments(a[i], a[after], b[j], b[(j + 1) % 3]));
        }
        const glm::dvec3 on_b = nearest_on_triangle(a[i], b), on_a = nearest_on_triangle(b[i], a);
        take({glm::length(a[i] - on_b), a[i], on_b});
        take({glm::length(b[i] - on_a), on_a, b[i]});
        for (const auto& at : {meeting_point(a[i], a[after], b), meeting_point(b[i], b[after], a)}) {
            if (at) {
                return {0, *at, *at};
            }
        }
    }
    return best;
}

}  // namespace ui
