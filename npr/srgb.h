// sRGB and linear light by table.
#pragma once

#include <array>
#include <cstdint>

namespace npr {

/// What npr/color.glsl computes, up to 1e-7, without powers.
class SrgbTables {
  public:
    /// Made once, when first asked for.
    [[nodiscard]] static const SrgbTables& get();

    /// `srgb` in [0, 1], to which others are clamped.
    [[nodiscard]] float linear(float srgb) const;
    /// The byte nearest to `linear` light in [0, 1], to which others are clamped.
    [[nodiscard]] std::uint8_t byte(float linear) const;

  private:
    SrgbTables();
    static constexpr int kSteps = 4096;
    std::array<float, kSteps + 2> linear_{};      ///< By sRGB in steps of 1 / kSteps.
    std::array<std::uint8_t, kSteps + 1> low_{};  ///< By linear light: the byte of the step's lower end.
    std::array<float, 257> from_{};               ///< By byte: the least linear light that it is nearest to.
};

}  // namespace npr
