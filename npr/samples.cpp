#include "npr/samples.h"

namespace npr {
namespace {

/// Sample i of n: row i of the pixel's n by n grid, and the column given.
template <std::size_t n>
constexpr std::array<glm::dvec2, n> rooks(const std::array<int, n>& columns) {
    std::array<glm::dvec2, n> offsets{};
    for (std::size_t i = 0; i < n; ++i) {
        offsets[i] = glm::dvec2((columns[i] + 0.5) / static_cast<double>(n) - 0.5,
                                (static_cast<double>(i) + 0.5) / static_cast<double>(n) - 0.5);
    }
    return offsets;
}

constexpr std::array kOne{glm::dvec2(0.0)};
constexpr auto kFour = rooks<4>({1, 3, 0, 2});
constexpr auto kEight = rooks<8>({3, 6, 1, 4, 7, 2, 5, 0});
constexpr auto kSixteen = rooks<16>({6, 12, 2, 9, 15, 4, 11, 0, 7, 13, 3, 10, 1, 8, 14, 5});

}  // namespace

std::span<const glm::dvec2> sample_offsets(int count) {
    if (count <= 1) {
        return kOne;
    }
    if (count <= 4) {
        return kFour;
    }
    if (count <= 8) {
        return kEight;
    }
    return kSixteen;
}

base::View sample_view(const Picture& picture, std::size_t sample, const glm::dvec3& lo, const glm::dvec3& hi) {
    return {picture.camera, picture.size, lo, hi, sample_offsets(picture.samples)[sample]};
}

}  // namespace npr
