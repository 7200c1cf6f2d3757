// What bytes of source text are, and where runs of them end.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <string_view>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace csg::scad {

/// A set of bytes.
class CharacterSet {
  public:
    constexpr explicit CharacterSet(std::string_view characters) {
        for (const char c : characters) {
            in_[static_cast<unsigned char>(c)] = true;
        }
    }
    [[nodiscard]] constexpr bool has(char c) const { return in_[static_cast<unsigned char>(c)]; }

  private:
    std::array<bool, 256> in_{};
};

/// What names are made of, but the `$` that they may begin with.
inline constexpr CharacterSet kWordCharacters("0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_");

inline bool is_word(char c) {
    return kWordCharacters.has(c);
}
inline bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

#ifdef __SSE2__
/// Sixteen bytes at a time: a loop by bytes ends at a place that no processor foresees. `found(bytes)` sets the bytes
/// at which to stop. Gives where that is, or where fewer than sixteen bytes are left.
template <typename Found>
const char* find_of_sixteen(const char* at, const char* end, const Found& found) {
    for (; end - at >= 16; at += 16) {
        const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at));
        if (const auto stops = static_cast<unsigned>(_mm_movemask_epi8(found(bytes))); stops != 0) {
            return at + std::countr_zero(stops);
        }
    }
    return at;
}

inline __m128i is_byte(__m128i bytes, char c) {
    return _mm_cmpeq_epi8(bytes, _mm_set1_epi8(c));
}
inline __m128i is_between(__m128i bytes, char low, char high) {
    return _mm_and_si128(_mm_cmpeq_epi8(_mm_max_epu8(bytes, _mm_set1_epi8(low)), bytes),
                         _mm_cmpeq_epi8(_mm_min_epu8(bytes, _mm_set1_epi8(high)), bytes));
}
#endif

/// Where, from `at` on, the first byte is that no word holds; `end` at the latest.
inline const char* end_of_word(const char* at, const char* end) {
#ifdef __SSE2__
    at = find_of_sixteen(at, end, [](__m128i bytes) {
        const __m128i letters = is_between(_mm_or_si128(bytes, _mm_set1_epi8(0x20)), 'a', 'z');
        const __m128i others = _mm_or_si128(is_between(bytes, '0', '9'), is_byte(bytes, '_'));
        return _mm_andnot_si128(_mm_or_si128(letters, others), _mm_set1_epi8(-1));
    });
#endif
    while (at != end && is_word(*at)) {
        ++at;
    }
    return at;
}

/// Where the first byte is that is no space.
inline const char* end_of_spaces(const char* at, const char* end) {
#ifdef __SSE2__
    at = find_of_sixteen(at, end,
                         [](__m128i bytes) { return _mm_andnot_si128(is_byte(bytes, ' '), _mm_set1_epi8(-1)); });
#endif
    while (at != end && *at == ' ') {
        ++at;
    }
    return at;
}

/// Where the line ends: at its \n or \r.
inline const char* end_of_line(const char* at, const char* end) {
#ifdef __SSE2__
    at = find_of_sixteen(at, end,
                         [](__m128i bytes) { return _mm_or_si128(is_byte(bytes, '\n'), is_byte(bytes, '\r')); });
#endif
    while (at != end && *at != '\n' && *at != '\r') {
        ++at;
    }
    return at;
}

}  // namespace csg::scad
