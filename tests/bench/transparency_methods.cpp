#include "tests/bench/transparency_methods.h"

#include <limits>

#include "npr/sorted/triangle_raster.h"

namespace bench {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

struct Target {
    glm::ivec2 size;
    std::vector<glm::vec3> color;
    std::vector<double> depth;

    explicit Target(const npr::Picture& picture)
        : size(picture.size),
          color(static_cast<std::size_t>(size.x * size.y), picture.scheme.background),
          depth(color.size(), kNothing) {}

    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
    }

    void draw_opaque(const ShadedTriangles& triangles, const base::View& view) {
        for (const auto& t : triangles.opaque) {
            npr::rasterize(view, t.eye, t.at, [&](int x, int y, double distance) {
                if (distance < depth[at(x, y)]) {
                    depth[at(x, y)] = distance;
                    color[at(x, y)] = glm::vec3(t.color);
                }
            });
        }
    }

    [[nodiscard]] base::Image image() const {
        base::Image result{size.x, size.y, std::vector<std::uint8_t>(4 * color.size(), 255)};
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                for (int c = 0; c < 3; ++c) {
                    result.rgba[4 * at(x, size.y - 1 - y) + static_cast<std::size_t>(c)] =
                        static_cast<std::uint8_t>(std::clamp(color[at(x, y)][c], 0.0F, 1.0F) * 255 + 0.5F);
                }
            }
        }
        return result;
    }
};

float chance(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    std::uint32_t h = x * 0x9e3779b1U ^ y * 0x85ebca77U ^ z * 0xc2b2ae3dU;
    for (int i = 0; i < 2; ++i) {
        h ^= h >> 15U;
        h *= 0x2c1b3c6dU;
        h ^= h >> 12U;
        h *= 0x297a2d39U;
    }
    return static_cast<float>(h >> 8U) / 16777216.0F;
}

}  // namespace

ShadedTriangles shade(const npr::ColoredMesh& mesh, const base::View& view) {
    ShadedTriangles result;
    const glm::dvec3 toward_light = glm::dvec3(-1, 1, 1) / std::sqrt(3.0);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        ShadedTriangles::Triangle t{};
        for (int corner = 0; corner < 3; ++corner) {
            const auto c = static_cast<std::size_t>(corner);
            t.eye[c] = glm::dvec3(view.eye_from_world() * glm::dvec4(mesh.points[mesh.triangles[i][corner]], 1.0));
            t.at[c] = npr::raster_corner(view, t.eye[c]);
        }
        const glm::dvec3 normal = glm::cross(t.eye[1] - t.eye[0], t.eye[2] - t.eye[0]);
        const double light = 0.2 + std::abs(glm::dot(glm::normalize(normal), toward_light));
        t.color = glm::vec4(glm::min(glm::vec3(mesh.colors[i]) * static_cast<float>(light), 1.0F), mesh.colors[i].a);
        const bool back = view.orthographic() ? normal.z <= 0 : glm::dot(normal, t.eye[0]) >= 0;
        if (t.color.a >= 1) {
            result.opaque.push_back(t);
        } else if (!back) {
            result.clear.push_back(t);
        }
    }
    return result;
}

base::Image weighted_blended(const ShadedTriangles& triangles, const npr::Picture& picture, const base::View& view) {
    Target target(picture);
    target.draw_opaque(triangles, view);
    std::vector<glm::vec4> sum(target.color.size(), glm::vec4(0));
    std::vector<float> through(target.color.size(), 1);
    const double near = view.near_distance(), far = view.far_distance();
    double most = near;
    for (const auto& t : triangles.clear) {
        for (const glm::dvec3& corner : t.eye) {
            most = std::max(most, -corner.z);
        }
    }
    const double range = std::isfinite(far) && far > near ? far - near : std::max(most - near, 1e-9);
    for (const auto& t : triangles.clear) {
        npr::rasterize(view, t.eye, t.at, [&](int x, int y, double distance) {
            const std::size_t at = target.at(x, y);
            if (distance < target.depth[at]) {
                const double away = 1 - std::clamp((distance - near) / range, 0.0, 1.0);
                const auto weight = static_cast<float>(t.color.a * std::max(1e-2, 3e3 * away * away * away));
                sum[at] += glm::vec4(glm::vec3(t.color) * t.color.a, t.color.a) * weight;
                through[at] *= 1 - t.color.a;
            }
        });
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
        const glm::vec3 mean = glm::vec3(sum[i]) / std::max(sum[i].a, 1e-5F);
        target.color[i] = mean * (1 - through[i]) + target.color[i] * through[i];
    }
    return target.image();
}

base::Image stochastic(const ShadedTriangles& triangles, const npr::Picture& picture, const base::View& view,
                       int samples) {
    Target target(picture);
    target.draw_opaque(triangles, view);
    const std::size_t pixels = target.color.size(), count = static_cast<std::size_t>(samples);
    std::vector<double> depth(pixels * count);
    std::vector<glm::vec3> color(pixels * count);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        depth[i] = target.depth[i / count];
        color[i] = target.color[i / count];
    }
    for (std::size_t t = 0; t < triangles.clear.size(); ++t) {
        const auto& triangle = triangles.clear[t];
        npr::rasterize(view, triangle.eye, triangle.at, [&](int x, int y, double distance) {
            const std::size_t at = target.at(x, y);
            // Stratified: of the samples as many are kept as opacity says, which ones is left to chance.
            const float kept = triangle.color.a * static_cast<float>(samples) +
                               chance(static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(t), 1);
            const auto first = static_cast<std::size_t>(
                chance(static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(t), 2) * static_cast<float>(samples));
            const std::size_t stride = samples > 1
                                           ? 2 * static_cast<std::size_t>(chance(static_cast<std::uint32_t>(at),
                                                                                 static_cast<std::uint32_t>(t), 3) *
                                                                          static_cast<float>(samples / 2)) +
                                                 1
                                           : 1;
            for (std::size_t i = 0; i < static_cast<std::size_t>(kept) && i < count; ++i) {
                const std::size_t sample = at * count + (first + i * stride) % count;
                if (distance < depth[sample]) {
                    depth[sample] = distance;
                    color[sample] = glm::vec3(triangle.color);
                }
            }
        });
    }
    for (std::size_t i = 0; i < pixels; ++i) {
        glm::vec3 sum(0);
        for (std::size_t sample = 0; sample < count; ++sample) {
            sum += color[i * count + sample];
        }
        target.color[i] = sum / static_cast<float>(samples);
    }
    return target.image();
}

}  // namespace bench
