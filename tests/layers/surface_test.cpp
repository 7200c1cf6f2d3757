// How surfaces are written into a stack, and read.
#include "layers/surface.h"

#include <gtest/gtest.h>

namespace {

using layers::Surface;

TEST(SurfaceCode, EverySurfaceComesBack) {
    const std::uint32_t largest = (std::uint32_t{1} << 31) - 1;
    for (const std::uint32_t leaf : {0U, 1U, 77U, largest - 1}) {
        for (const std::uint32_t plane : {0U, 1U, 99U, largest}) {
            for (const bool reversed : {false, true}) {
                for (const bool leaving : {false, true}) {
                    const Surface s{0.25F, leaf, plane, reversed, leaving};
                    EXPECT_EQ(layers::decode(s.depth, layers::encode(s)), s);
                    EXPECT_NE(layers::encode(s).x, layers::kNoSurface);
                }
            }
        }
    }
}

TEST(SurfaceCode, NoSurfaceIsOneWord) {
    EXPECT_EQ(layers::decode(0, {layers::kNoSurface, 0}), Surface{});
    EXPECT_EQ(layers::decode(0, {layers::kNoSurface, 0}).depth, 0.0F);
}

}  // namespace
