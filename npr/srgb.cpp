#include "npr/srgb.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace npr {
namespace {

double linear_from_srgb(double c) {
    return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92;
}

}  // namespace

const SrgbTables& SrgbTables::get() {
    static const SrgbTables tables;
    return tables;
}

SrgbTables::SrgbTables() {
    for (std::size_t i = 0; i < linear_.size(); ++i) {
        linear_[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / kSteps));
    }
    for (std::size_t i = 1; i < 256; ++i) {
        from_[i] = static_cast<float>(linear_from_srgb((static_cast<double>(i) - 0.5) / 255));
    }
    from_[0] = 0;
    from_[256] = std::numeric_limits<float>::infinity();
    std::uint8_t at = 0;
    for (std::size_t i = 0; i < low_.size(); ++i) {
        while (from_[at + std::size_t{1}] <= static_cast<float>(i) / kSteps) {
            ++at;
        }
        low_[i] = at;
    }
}

float SrgbTables::linear(float srgb) const {
    const float at = std::clamp(srgb, 0.0F, 1.0F) * kSteps;
    const auto i = static_cast<std::size_t>(at);
    return linear_[i] + (at - static_cast<float>(i)) * (linear_[i + 1] - linear_[i]);
}

std::uint8_t SrgbTables::byte(float linear) const {
    const float c = std::clamp(linear, 0.0F, 1.0F);
    std::size_t result = low_[static_cast<std::size_t>(c * kSteps)];
    while (from_[result + 1] <= c) {
        ++result;
    }
    return static_cast<std::uint8_t>(result);
}

}  // namespace npr
