#include "ui/pipeline/editing/sparse_step.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "ui/pipeline/editing/text_edit.h"

namespace ui {

namespace {

using NumberChanges = std::vector<std::pair<std::size_t, double>>;

/// Part of r that may be missed: the next step sees to it.
constexpr double kMissed = 1e-3;
/// Columns that are nearer to a plane, or a line, than this part of their length do not span more.
constexpr double kFlatness = 1e-6;

/// By least squares with these columns alone, at most three.
std::optional<NumberChanges> step_with(const std::vector<glm::dvec3>& columns, const glm::dvec3& r,
                                       const std::vector<std::size_t>& chosen) {
    // Gram and Schmidt: with so few columns as exact as any other way.
    std::vector<glm::dvec3> directions;
    std::vector<std::vector<double>> upper(chosen.size(), std::vector<double>(chosen.size(), 0.0));
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        glm::dvec3 left = columns[chosen[i]];
        for (std::size_t k = 0; k < i; ++k) {
            upper[k][i] = glm::dot(directions[k], left);
            left -= upper[k][i] * directions[k];
        }
        upper[i][i] = glm::length(left);
        if (!(upper[i][i] > kFlatness * glm::length(columns[chosen[i]]))) {
            return {};
        }
        directions.push_back(left / upper[i][i]);
    }
    NumberChanges step(chosen.size());
    glm::dvec3 reached(0.0);
    for (std::size_t i = chosen.size(); i-- > 0;) {
        double x = glm::dot(directions[i], r);
        for (std::size_t k = i + 1; k < chosen.size(); ++k) {
            x -= upper[i][k] * step[k].second;
        }
        step[i] = {chosen[i], x / upper[i][i]};
        reached += step[i].second * columns[chosen[i]];
    }
    return glm::distance(reached, r) <= kMissed * glm::length(r) ? std::optional(step) : std::nullopt;
}

/// Calls visit(chosen) for all choices of `count` of those.
template <typename Visit>
void for_each_choice(const std::vector<std::size_t>& of, std::size_t count, const Visit& visit) {
    std::vector<bool> taken(of.size(), false);
    std::fill(taken.begin(), taken.begin() + static_cast<std::ptrdiff_t>(count), true);
    do {
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0; i < of.size(); ++i) {
            if (taken[i]) {
                chosen.push_back(of[i]);
            }
        }
        visit(chosen);
    } while (std::prev_permutation(taken.begin(), taken.end()));
}

}  // namespace

std::optional<NumberChanges> sparse_step(const std::vector<glm::dvec3>& columns, const glm::dvec3& r,
                                         const std::vector<double>& values, double tolerance) {
    std::vector<std::size_t> moving;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const double length = glm::length(columns[i]);
        if (length > 0 && std::isfinite(length)) {
            moving.push_back(i);
        }
    }
    for (std::size_t count = 1; count <= std::min<std::size_t>(3, moving.size()); ++count) {
        std::optional<NumberChanges> best;
        std::tuple<std::size_t, double> least;
        for_each_choice(moving, count, [&](const std::vector<std::size_t>& chosen) {
            auto step = step_with(columns, r, chosen);
            if (!step) {
                return;
            }
            std::size_t digits = 0;
            double change = 0;
            for (const auto& [column, x] : *step) {
                digits += short_number(values[column] + x, tolerance).size();
                change += x * x;
            }
            if (!best || std::tuple(digits, change) < least) {
                least = {digits, change};
                best = std::move(step);
            }
        });
        if (best) {
            return best;
        }
    }
    return {};
}

}  // namespace ui
