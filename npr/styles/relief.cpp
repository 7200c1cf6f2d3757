#include "npr/styles/relief.h"

#include <algorithm>
#include <cmath>

namespace npr {
namespace {

/// Surfaces that are this share of the scene behind the nearest in a cell count a quarter there.
constexpr double kNearby = 0.05;

struct Cells {
    glm::ivec2 size{0};
    std::vector<double> value, weight;  ///< Weight 0: nothing is known.

    explicit Cells(glm::ivec2 of) : size(of), value(count(), 0), weight(count(), 0) {}
    [[nodiscard]] std::size_t count() const {
        return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    }
    [[nodiscard]] std::size_t at(glm::ivec2 p) const {
        p = glm::clamp(p, glm::ivec2(0), size - 1);
        return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(p.x);
    }
};

/// Fills the cells of which nothing is known from coarser and coarser grids (Gortler et al. 1996: pull and push).
void fill(Cells& fine) {
    if (fine.size.x <= 1 && fine.size.y <= 1) {
        return;
    }
    Cells coarse((fine.size + 1) / 2);
    for (int y = 0; y < fine.size.y; ++y) {
        for (int x = 0; x < fine.size.x; ++x) {
            const std::size_t from = fine.at({x, y}), to = coarse.at({x / 2, y / 2});
            coarse.value[to] += fine.weight[from] * fine.value[from];
            coarse.weight[to] += fine.weight[from];
        }
    }
    for (std::size_t i = 0; i < coarse.count(); ++i) {
        if (coarse.weight[i] > 0) {
            coarse.value[i] /= coarse.weight[i];
            coarse.weight[i] = std::min(coarse.weight[i], 1.0);
        }
    }
    fill(coarse);
    for (int y = 0; y < fine.size.y; ++y) {
        for (int x = 0; x < fine.size.x; ++x) {
            const std::size_t to = fine.at({x, y});
            if (fine.weight[to] > 0) {
                continue;
            }
            // Three quarters of the cell above, and of its neighbors toward this quarter of it.
            const glm::ivec2 up(x / 2, y / 2), aside(2 * (x % 2) - 1, 2 * (y % 2) - 1);
            const auto of = [&](int dx, int dy) { return coarse.value[coarse.at(up + glm::ivec2(dx, dy))]; };
            fine.value[to] = (9 * of(0, 0) + 3 * of(aside.x, 0) + 3 * of(0, aside.y) + of(aside.x, aside.y)) / 16;
        }
    }
    for (std::size_t i = 0; i < fine.count(); ++i) {
        fine.weight[i] = std::max(fine.weight[i], 1e-9);
    }
}

}  // namespace

Relief relief_of(const base::View& view, std::span<const float> depths, float cell, double center, double diagonal) {
    const glm::ivec2 pixels = view.size();
    const glm::dvec2 half = 0.5 * glm::dvec2(pixels);
    Cells cells(2 * (glm::ivec2(glm::ceil(half / static_cast<double>(cell))) + 1));
    const auto cells_of = [&](int axis) {
        std::vector<std::size_t> of(static_cast<std::size_t>(pixels[axis]));
        for (int i = 0; i < pixels[axis]; ++i) {
            const double place = (i + 0.5 - half[axis]) / static_cast<double>(cell);
            of[static_cast<std::size_t>(i)] =
                static_cast<std::size_t>(static_cast<int>(std::floor(place)) + cells.size[axis] / 2);
        }
        return of;
    };
    const std::vector<std::size_t> columns = cells_of(0), rows = cells_of(1);
    std::vector<float> nearest(cells.count(), 0);
    const auto for_each_pixel = [&](const auto& action) {
        std::size_t i = 0;
        for (int y = 0; y < pixels.y; ++y) {
            for (int x = 0; x < pixels.x; ++x, ++i) {
                if (depths[i] > 0) {
                    action(rows[static_cast<std::size_t>(y)] * static_cast<std::size_t>(cells.size.x) +
                               columns[static_cast<std::size_t>(x)],
                           depths[i]);
                }
            }
        }
    };
    for_each_pixel([&](std::size_t at, float depth) { nearest[at] = std::max(nearest[at], depth); });
    std::vector<double> least(cells.count());
    std::transform(nearest.begin(), nearest.end(), least.begin(),
                   [&](float depth) { return depth > 0 ? view.distance(static_cast<double>(depth)) : 0; });
    bool any = false;
    for_each_pixel([&](std::size_t at, float depth) {
        const double distance = view.distance(static_cast<double>(depth));
        const double behind = (distance - least[at]) / (kNearby * diagonal);
        const double weight = 1 / ((1 + behind * behind) * (1 + behind * behind));
        cells.value[at] += weight * distance;
        cells.weight[at] += weight;
        any = true;
    });
    for (std::size_t i = 0; i < cells.count(); ++i) {
        if (cells.weight[i] > 0) {
            cells.value[i] /= cells.weight[i];
            cells.weight[i] = 1;
        }
    }
    if (any) {
        fill(cells);
    } else {
        std::fill(cells.value.begin(), cells.value.end(), center);
    }
    Relief relief{cells.size, cell, {}};
    relief.distances.assign(cells.value.begin(), cells.value.end());
    return relief;
}

}  // namespace npr
