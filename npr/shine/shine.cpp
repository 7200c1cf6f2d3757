#include "npr/shine/shine.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "base/parallel.h"
#include "npr/shine/vertex_shine.h"
#include "npr/shine/view_dependent_settings.h"

namespace npr {
namespace {

struct Box {
    glm::ivec2 lo{0}, hi{0};  ///< Inclusive.
};

std::vector<std::pair<glm::uint, Box>> boxes_of_parts(glm::ivec2 size, std::span<const glm::uint> keys) {
    std::map<glm::uint, Box> boxes;
    std::size_t at = 0;
    glm::uint last = 0;
    Box* box = nullptr;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x, ++at) {
            const glm::uint part = keys[at] >> 1U;
            if (part == 0) {
                continue;
            }
            const glm::ivec2 pixel(x, y);
            if (part != last) {
                box = &boxes.try_emplace(part, Box{pixel, pixel}).first->second;
                last = part;
            }
            box->lo = glm::min(box->lo, pixel);
            box->hi = glm::max(box->hi, pixel);
        }
    }
    return {boxes.begin(), boxes.end()};
}

/// One part's distances, within its box.
class PartDistances {
  public:
    PartDistances(glm::ivec2 picture, std::span<const glm::uint> keys, glm::uint part, const Box& box)
        : picture_(picture),
          keys_(keys),
          part_(part),
          box_(box),
          size_(box.hi - box.lo + 1),
          none_(size_.x + size_.y) {}

    void write(std::span<float> distances) {
        find_along_columns();
        for (int y = 0; y < size_.y; ++y) {
            find_along_row(y, distances);
        }
    }

  private:
    [[nodiscard]] std::size_t in_picture(int x, int y) const {
        return static_cast<std::size_t>(box_.lo.y + y) * static_cast<std::size_t>(picture_.x) +
               static_cast<std::size_t>(box_.lo.x + x);
    }
    [[nodiscard]] std::size_t in_box(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
    }

    /// To the nearest silhouette of each pixel's column; none_ where there is none.
    void find_along_columns() {
        columns_.assign(in_box(0, size_.y), none_);
        const glm::uint source = part_ << 1U | 1U;
        for (int y = 0; y < size_.y; ++y) {
            for (int x = 0; x < size_.x; ++x) {
                const int below = y > 0 ? std::min(columns_[in_box(x, y - 1)] + 1, none_) : none_;
                columns_[in_box(x, y)] = keys_[in_picture(x, y)] == source ? 0 : below;
            }
        }
        for (int y = size_.y - 2; y >= 0; --y) {
            for (int x = 0; x < size_.x; ++x) {
                columns_[in_box(x, y)] = std::min(columns_[in_box(x, y)], columns_[in_box(x, y + 1)] + 1);
            }
        }
    }

    /// The lower envelope of the parabolas of a row's columns, in whole numbers.
    void find_along_row(int y, std::span<float> distances) {
        const auto squared = [&](std::int64_t x, std::int64_t i) {
            const std::int64_t g = columns_[in_box(static_cast<int>(i), y)];
            return (x - i) * (x - i) + g * g;
        };
        // The first x at which column u is at least as near as i, which is before it.
        const auto taken_over = [&](std::int64_t i, std::int64_t u) {
            const std::int64_t above = squared(0, u) - squared(0, i), below = 2 * (u - i);
            return (above >= 0 ? (above + below - 1) / below : -(-above / below));
        };
        centers_.clear();
        starts_.clear();
        for (int u = 0; u < size_.x; ++u) {
            if (columns_[in_box(u, y)] >= none_) {
                continue;
            }
            while (!centers_.empty() && squared(starts_.back(), centers_.back()) > squared(starts_.back(), u)) {
                centers_.pop_back();
                starts_.pop_back();
            }
            const std::int64_t start = centers_.empty() ? 0 : taken_over(centers_.back(), u);
            if (start < size_.x) {
                centers_.push_back(u);
                starts_.push_back(start);
            }
        }
        std::size_t next = 0;
        for (int x = 0; x < size_.x && !centers_.empty(); ++x) {
            while (next + 1 < centers_.size() && starts_[next + 1] <= x) {
                ++next;
            }
            if (keys_[in_picture(x, y)] >> 1U == part_) {
                distances[in_picture(x, y)] =
                    static_cast<float>(std::sqrt(static_cast<double>(squared(x, centers_[next]))));
            }
        }
    }

    glm::ivec2 picture_;
    std::span<const glm::uint> keys_;
    glm::uint part_;
    Box box_;
    glm::ivec2 size_;
    int none_;
    std::vector<int> columns_;
    std::vector<std::int64_t> centers_, starts_;
};

constexpr int kNothingHides = 1 << 30;  ///< As npr/shine/shine_rules.glsl has it.

/// Of a line of that width inside of the silhouette, whose own pixels are at distance 0.
float ink_at(float distance, float width) {
    return distance < 0 ? 0 : std::clamp(width - distance, 0.0F, 1.0F);
}

}  // namespace

std::vector<float> silhouette_distances(glm::ivec2 size, std::span<const glm::uint> keys) {
    std::vector<float> distances(keys.size(), -1.0F);
    const auto boxes = boxes_of_parts(size, keys);
    base::for_each_index(static_cast<int>(boxes.size()), [&] {
        return [&](int i) {
            const auto& [part, box] = boxes[static_cast<std::size_t>(i)];
            PartDistances(size, keys, part, box).write(distances);
        };
    });
    return distances;
}

float radius_in_pixels(const layers::PartLook& part, const base::View& view, const glm::dvec3& local_center) {
    const glm::dvec4 center = view.eye_from_world() * glm::dvec4(glm::dvec3(part.center) + local_center, 1.0);
    const double a_pixel = 2 * view.half_height() / view.size().y;
    const double away = view.orthographic() ? 1 : std::max({-center.z, view.near_distance(), 1e-3 * part.radius});
    return static_cast<float>(part.radius / (a_pixel * away));
}

std::vector<ShineRow> shine_rows(const Picture& picture, const base::View& view,
                                 std::span<const layers::PartLook> parts, const glm::dvec3& local_center,
                                 std::span<const ShineSource> sources, const ColoredMesh* mesh) {
    const auto settings = transparency_settings<ViewDependentSettings>(picture);
    const auto distances = [&](glm::uint ShineSource::*key) {
        std::vector<glm::uint> keys(sources.size());
        std::transform(sources.begin(), sources.end(), keys.begin(), [&](const ShineSource& s) { return s.*key; });
        return silhouette_distances(picture.size, keys);
    };
    const std::vector<float> front = distances(&ShineSource::front_key);
    const std::vector<float> solid =
        settings.silhouette_width > 0 ? distances(&ShineSource::solid_key) : std::vector<float>(sources.size(), -1.0F);
    std::vector<float> by_vertex;
    if (mesh != nullptr && settings.opacity == static_cast<int>(ShineOpacity::Vertices)) {
        by_vertex = clearness_by_vertex(*mesh, view, parts, settings.falloff, sources);
    }
    std::vector<float> radii;
    for (const layers::PartLook& part : parts) {
        radii.push_back(std::max(radius_in_pixels(part, view, local_center), 1.0F));
    }
    std::vector<ShineRow> rows(sources.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ShineSource& source = sources[i];
        rows[i] = {source.front, source.last, kNothingHides, 1, 0, ink_at(solid[i], settings.silhouette_width)};
        if (source.front < 0) {
            continue;
        }
        rows[i].hidden = source.last + (source.solid_key != 0 ? 1 : 0);
        const float weight = source.solid_key != 0 ? settings.opaque : settings.background;
        if (!by_vertex.empty()) {
            rows[i].alpha = 1 - weight * by_vertex[i];
        } else {
            const float radius = radii[(source.front_key >> 1U) - 1];
            const float away = front[i] < 0 ? 1.0F : std::min(front[i] / radius, 1.0F);
            rows[i].alpha = 1 - weight * (away > 0 ? std::pow(away, settings.falloff) : 0.0F);
        }
        rows[i].front_ink = ink_at(front[i], settings.silhouette_width);
    }
    return rows;
}

}  // namespace npr
