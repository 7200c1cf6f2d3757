#include <cmath>

#include "tests/edges/edge_points.h"

namespace edges {
namespace {

/// Of the first layer, by pixel; what has nothing has zeros.
std::vector<glm::vec3> values_of(const layers::HostStack& stack, const base::View& view, Buffer buffer) {
    std::vector<glm::vec3> values;
    for (int y = 0; y < stack.size.y; ++y) {
        for (int x = 0; x < stack.size.x; ++x) {
            const layers::Surface s = stack.at(0, x, y);
            glm::vec3 value(0);
            if (s.depth > 0 && buffer == Buffer::Depth) {
                const auto near = static_cast<float>(view.near_distance()),
                           far = static_cast<float>(view.far_distance());
                const float distance = view.orthographic() ? far - s.depth * (far - near) : near / s.depth;
                value.x = 1.5F - (distance - near) / (far - near);
            } else if (s.depth > 0 && buffer == Buffer::Normal) {
                const glm::vec3 n(stack.table->planes[s.plane]);
                const glm::vec3 ray(view.ray(x + 0.5, y + 0.5).direction);
                value = glm::dot(n, ray) > 0 ? -n : n;
            } else if (s.depth > 0) {
                value.x = static_cast<float>(s.leaf + 1);
            }
            values.push_back(value);
        }
    }
    return values;
}

std::vector<Point> above(const std::vector<float>& strength, glm::ivec2 size, float threshold) {
    std::vector<Point> points;
    for (int y = 1; y + 1 < size.y; ++y) {
        for (int x = 1; x + 1 < size.x; ++x) {
            if (strength[static_cast<std::size_t>(y * size.x + x)] > threshold) {
                points.push_back({{x + 0.5, y + 0.5}});
            }
        }
    }
    return points;
}

}  // namespace

Score sobel_score(const layers::HostStack& stack, const base::View& view, Buffer buffer,
                  const std::vector<Point>& truth) {
    const std::vector<glm::vec3> values = values_of(stack, view, buffer);
    const glm::ivec2 size = stack.size;
    std::vector<float> strength(values.size());
    for (int y = 1; y + 1 < size.y; ++y) {
        for (int x = 1; x + 1 < size.x; ++x) {
            const auto at = [&](int dx, int dy) {
                return values[static_cast<std::size_t>((y + dy) * size.x + x + dx)];
            };
            const glm::vec3 across = at(1, -1) + 2.0F * at(1, 0) + at(1, 1) - at(-1, -1) - 2.0F * at(-1, 0) - at(-1, 1);
            const glm::vec3 up = at(-1, 1) + 2.0F * at(0, 1) + at(1, 1) - at(-1, -1) - 2.0F * at(0, -1) - at(1, -1);
            strength[static_cast<std::size_t>(y * size.x + x)] = std::sqrt(glm::dot(across, across) + glm::dot(up, up));
        }
    }
    if (buffer == Buffer::Id) {
        return score(truth, above(strength, size, 0), size);
    }
    Score best;
    for (int i = 0; i < 8; ++i) {
        const float threshold = buffer == Buffer::Depth ? 0.005F * std::exp2(static_cast<float>(i))
                                                        : 0.25F * std::exp2(static_cast<float>(i) / 2);
        const Score s = score(truth, above(strength, size, threshold), size);
        if (best.points == 0 || s.f() > best.f()) {
            best = s;
        }
    }
    return best;
}

}  // namespace edges
