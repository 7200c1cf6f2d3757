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

/// The same with one in each cell of a grid of side by side (correlated multi-jitter, Kensler 2013). `stride`: odd,
/// about 0.38 of them, so that any first few are spread over the pixel.
template <std::size_t side>
constexpr std::array<glm::dvec2, side * side> cells(std::size_t stride) {
    std::array<int, side * side> columns{};
    for (std::size_t x = 0; x < side; ++x) {
        for (std::size_t y = 0; y < side; ++y) {
            columns[y * side + x] = static_cast<int>(x * side + y);
        }
    }
    const auto in_order = rooks(columns);
    std::array<glm::dvec2, side * side> offsets{};
    std::size_t next = 0;
    for (auto& offset : offsets) {
        offset = in_order[next];
        next = (next + stride) % (side * side);
    }
    return offsets;
}

constexpr std::array kOne{glm::dvec2(0.0)};
constexpr auto kFour = rooks<4>({1, 3, 0, 2});
constexpr auto kEight = rooks<8>({3, 6, 1, 4, 7, 2, 5, 0});
constexpr auto kSixteen = rooks<16>({6, 12, 2, 9, 15, 4, 11, 0, 7, 13, 3, 10, 1, 8, 14, 5});
constexpr auto kSixtyFour = cells<8>(25);
constexpr auto kMost = cells<16>(97);

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
    if (count <= 16) {
        return kSixteen;
    }
    if (count <= 64) {
        return kSixtyFour;
    }
    return kMost;
}

base::View sample_view(const Picture& picture, std::size_t sample, const glm::dvec3& lo, const glm::dvec3& hi) {
    return {picture.camera, picture.size, lo, hi, sample_offsets(picture.samples)[sample]};
}

}  // namespace npr
