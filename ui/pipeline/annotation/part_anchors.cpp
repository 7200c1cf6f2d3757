#include "ui/pipeline/annotation/part_anchors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {

namespace {

/// What a layer shows, by pixel, and how far each is from what is something else.
class GroupMap {
  public:
    GroupMap(const Model& model, const layers::HostStack& stack, int layer, std::span<const std::uint32_t> group_of)
        : size_(stack.size), groups_(pixels(), kNoGroup), inside_(pixels(), 0) {
        for (int y = 0; y < size_.y; ++y) {
            for (int x = 0; x < size_.x; ++x) {
                const layers::Surface surface = stack.at(layer, x, y);
                if (surface.depth > 0) {
                    groups_[index(x, y)] = group_of[model.scene.leaves[surface.leaf].part];
                }
            }
        }
        measure();
    }

    [[nodiscard]] std::uint32_t group(int x, int y) const { return groups_[index(x, y)]; }
    [[nodiscard]] std::int32_t inside(int x, int y) const { return inside_[index(x, y)]; }
    [[nodiscard]] glm::ivec2 size() const { return size_; }

  private:
    [[nodiscard]] std::size_t pixels() const {
        return static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
    }

    /// Steps like a king's to the nearest pixel of another group (Rosenfeld and Pfaltz 1966): from the lower left, then
    /// from the upper right.
    void measure() {
        constexpr std::array<glm::ivec2, 4> kBefore{glm::ivec2(-1, 0), {-1, -1}, {0, -1}, {1, -1}};
        const auto look = [&](int x, int y, int sign, std::int32_t most) {
            for (const glm::ivec2& step : kBefore) {
                const int nx = x + sign * step.x, ny = y + sign * step.y;
                const bool same = nx >= 0 && ny >= 0 && nx < size_.x && ny < size_.y && group(nx, ny) == group(x, y);
                most = std::min(most, same ? inside(nx, ny) + 1 : 1);
            }
            inside_[index(x, y)] = most;
        };
        for (int y = 0; y < size_.y; ++y) {
            for (int x = 0; x < size_.x; ++x) {
                look(x, y, 1, size_.x + size_.y);
            }
        }
        for (int y = size_.y; y-- > 0;) {
            for (int x = size_.x; x-- > 0;) {
                look(x, y, -1, inside(x, y));
            }
        }
    }

    glm::ivec2 size_;
    std::vector<std::uint32_t> groups_;
    std::vector<std::int32_t> inside_;
};

}  // namespace

glm::dvec3 point_behind(const Model& model, const base::View& view, const glm::ivec2& pixel,
                        const layers::Surface& surface) {
    const base::View::Ray ray = view.ray(pixel.x, pixel.y);
    double distance = view.distance(surface.depth);
    // The plane tells more exactly than the depth, unless it is seen from the side.
    const csg::solid::Plane& plane = model.geometry.planes.planes()[surface.plane];
    const double slope = glm::dot(plane.normal, ray.direction);
    const double exact = (plane.offset - glm::dot(plane.normal, ray.origin)) / slope;
    if (std::abs(exact - distance) <= 1e-5 * std::abs(distance)) {
        distance = exact;
    }
    return ray.origin + distance * ray.direction;
}

std::vector<std::optional<PartAnchor>> part_anchors(const Model& model, const base::View& view,
                                                    const layers::HostStack& stack,
                                                    std::span<const std::uint32_t> group_of_part, std::size_t groups) {
    std::vector<std::optional<PartAnchor>> anchors(groups);
    for (int layer = 0; layer < stack.layers; ++layer) {
        if (std::all_of(anchors.begin(), anchors.end(), [](const auto& anchor) { return anchor.has_value(); })) {
            break;
        }
        const GroupMap map(model, stack, layer, group_of_part);
        std::vector<glm::dvec2> middles(groups, glm::dvec2(0.0));
        std::vector<double> counts(groups, 0), nearest(groups, INFINITY);
        const auto visit = [&](const auto& each) {
            for (int y = 0; y < map.size().y; ++y) {
                for (int x = 0; x < map.size().x; ++x) {
                    if (const std::uint32_t group = map.group(x, y);
                        group != kNoGroup && (!anchors[group] || anchors[group]->layer == layer)) {
                        each(group, x, y);
                    }
                }
            }
        };
        visit([&](std::uint32_t group, int x, int y) {
            middles[group] += glm::dvec2(x, y);
            counts[group] += 1;
        });
        visit([&](std::uint32_t group, int x, int y) {
            const double far = glm::distance(middles[group] / counts[group], glm::dvec2(x, y));
            auto& best = anchors[group];
            if (!best || map.inside(x, y) > best->inside ||
                (map.inside(x, y) == best->inside && far < nearest[group])) {
                best = PartAnchor{{x, y}, {}, layer, map.inside(x, y)};
                nearest[group] = far;
            }
        });
    }
    for (auto& anchor : anchors) {
        if (anchor) {
            anchor->point =
                point_behind(model, view, anchor->pixel, stack.at(anchor->layer, anchor->pixel.x, anchor->pixel.y));
        }
    }
    return anchors;
}

}  // namespace ui
