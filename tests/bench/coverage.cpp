#include "tests/bench/coverage.h"

#include <algorithm>
#include <cmath>

#include "goldfeather/lists_cpu/lists_cpu.h"

namespace bench {

ExactCoverage::ExactCoverage(const ui::Model& model, const base::Camera& camera) {
    const base::View view(camera, glm::ivec2(kSide), model.geometry.box.lo, model.geometry.box.hi);
    layers::HostStack layers;
    goldfeather::ListsStats stats;
    goldfeather::peel_lists({model.scene, model.geometry}, view, 1, 0, layers, stats);
    hits_.resize(layers.counts.size());
    std::transform(layers.counts.begin(), layers.counts.end(), hits_.begin(),
                   [](int count) { return static_cast<std::uint8_t>(std::min(count, 1)); });
}

double ExactCoverage::error_percent(int side, std::span<const double> shown) const {
    const int block = kSide / side;
    double wrong = 0, covered = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            std::ptrdiff_t hits = 0;
            for (int sy = y * block; sy < (y + 1) * block; ++sy) {
                const auto row = hits_.begin() + static_cast<std::ptrdiff_t>(sy) * kSide + x * block;
                hits += std::count(row, row + block, std::uint8_t{1});
            }
            const double exact = static_cast<double>(hits) / (block * block);
            covered += exact;
            wrong += std::abs(
                exact -
                shown[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x)]);
        }
    }
    return covered > 0 ? 100 * wrong / covered : 0;
}

double ExactCoverage::difference_percent(const ExactCoverage& other) const {
    std::size_t wrong = 0, covered = 0;
    for (std::size_t i = 0; i < hits_.size(); ++i) {
        wrong += hits_[i] != other.hits_[i] ? 1 : 0;
        covered += other.hits_[i];
    }
    return covered > 0 ? 100 * static_cast<double>(wrong) / static_cast<double>(covered) : 0;
}

}  // namespace bench
