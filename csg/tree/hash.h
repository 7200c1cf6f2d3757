// Content hashes: 64 bits, the same in every run and on every machine.
#pragma once

#include <bit>
#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>

namespace csg {

/// Mixes `value` into `seed` (the finalizer of SplitMix64 over a rotated seed).
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t seed, std::uint64_t value) {
    std::uint64_t x = std::rotl(seed, 23) ^ (value + 0x9e3779b97f4a7c15ULL);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

/// Zeros of either sign hash alike, as they compare equal.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t seed, double value) {
    return mix(seed, std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value));
}

[[nodiscard]] inline std::uint64_t mix(std::uint64_t seed, const glm::dvec3& v) {
    return mix(mix(mix(seed, v.x), v.y), v.z);
}

[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t seed, std::string_view text) {
    seed = mix(seed, std::uint64_t{text.size()});
    for (const char c : text) {
        seed = mix(seed, std::uint64_t{static_cast<unsigned char>(c)});
    }
    return seed;
}

}  // namespace csg
