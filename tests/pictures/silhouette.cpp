#include "tests/pictures/silhouette.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

namespace pictures {

Background background(const base::Image& image) {
    std::map<std::array<int, 3>, int> counts;
    const auto count = [&](int x, int y) {
        const std::uint8_t* p = image.pixel(x, y);
        ++counts[{p[0], p[1], p[2]}];
    };
    for (int x = 0; x < image.width; ++x) {
        count(x, 0);
        count(x, image.height - 1);
    }
    for (int y = 0; y < image.height; ++y) {
        count(0, y);
        count(image.width - 1, y);
    }
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return {most->first[0], most->first[1], most->first[2]};
}

std::vector<bool> silhouette(const base::Image& image, const Background& background) {
    constexpr int kTolerance = 3;
    std::vector<bool> result;
    result.reserve(image.rgba.size() / 4);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        result.push_back(std::abs(image.rgba[i] - background.r) > kTolerance ||
                         std::abs(image.rgba[i + 1] - background.g) > kTolerance ||
                         std::abs(image.rgba[i + 2] - background.b) > kTolerance);
    }
    return result;
}

double overlap(const base::Image& expected, const base::Image& drawn) {
    if (expected.width != drawn.width || expected.height != drawn.height) {
        return 0;
    }
    const Background behind = background(expected);
    const std::vector<bool> a = silhouette(expected, behind), b = silhouette(drawn, behind);
    std::size_t both = 0, any = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += a[i] && b[i] ? 1 : 0;
        any += a[i] || b[i] ? 1 : 0;
    }
    return any == 0 ? 1 : static_cast<double>(both) / static_cast<double>(any);
}

base::Image difference(const base::Image& expected, const base::Image& drawn) {
    base::Image result{expected.width, expected.height, std::vector<std::uint8_t>(expected.rgba.size(), 0)};
    const Background behind = background(expected);
    const std::vector<bool> a = silhouette(expected, behind), b = silhouette(drawn, behind);
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        result.rgba[4 * i] = a[i] && !b[i] ? 255 : 0;
        result.rgba[4 * i + 1] = b[i] && !a[i] ? 200 : 0;
        result.rgba[4 * i + 3] = 255;
    }
    return result;
}

}  // namespace pictures
