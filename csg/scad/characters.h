// What bytes of source text are.
#pragma once

#include <array>
#include <string_view>

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

}  // namespace csg::scad
