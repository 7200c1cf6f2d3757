// Pictures as height maps, against volumes that OpenSCAD finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "csg/solid/files.h"
#include "tests/csg/solid/mesh_volume.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace csg::solid;

std::string big_endian(std::uint32_t n) {
    return {static_cast<char>(n >> 24U), static_cast<char>(n >> 16U), static_cast<char>(n >> 8U), static_cast<char>(n)};
}

std::string chunk(const std::string& kind, const std::string& body) {
    std::uint32_t sum = ~0U;
    for (const char byte : kind + body) {
        sum ^= static_cast<unsigned char>(byte);
        for (int i = 0; i < 8; ++i) {
            sum = sum >> 1U ^ ((sum & 1U) != 0 ? 0xedb88320U : 0U);
        }
    }
    return big_endian(static_cast<std::uint32_t>(body.size())) + kind + body + big_endian(~sum);
}

/// A stream of zlib that is not compressed.
std::string stored(const std::string& bytes) {
    std::uint32_t a = 1, b = 0;
    for (const char byte : bytes) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    const auto n = static_cast<std::uint32_t>(bytes.size());
    const auto low = [](std::uint32_t k) { return std::string{static_cast<char>(k), static_cast<char>(k >> 8U)}; };
    return "\x78\x01\x01" + low(n) + low(~n) + bytes + big_endian(b << 16U | a);
}

enum class Kind : char { Gray = 0, Color = 2, Palette = 3, GrayAlpha = 4 };

constexpr unsigned kValues[3][3] = {{10, 60, 200}, {0, 128, 255}, {33, 77, 99}};

/// Three by three pixels: kValues, cut to so many bits.
std::string picture(Kind kind, unsigned bits, const std::string& before = {}, unsigned subtract = 0) {
    std::string rows;
    for (const auto& row : kValues) {
        rows += '\0';
        unsigned filled = 0, byte = 0;
        for (const unsigned value : row) {
            const auto sample = [&](unsigned v) {
                if (bits == 16) {
                    rows += big_endian(v * 257 - (v > 0 ? subtract : 0)).substr(2);
                } else if (bits == 8) {
                    rows += static_cast<char>(v);
                }
            };
            if (bits >= 8) {
                sample(value);
                if (kind == Kind::GrayAlpha) {
                    sample(100);
                }
                if (kind == Kind::Color) {
                    sample(255 - value);
                    sample(7);
                }
                continue;
            }
            byte = byte << bits | value * ((1U << bits) - 1) / 255;
            filled += bits;
            if (filled == 8) {
                rows += static_cast<char>(byte);
            }
            filled %= 8;
        }
        if (filled != 0) {
            rows += static_cast<char>(byte << (8 - filled));
        }
    }
    const std::string header =
        big_endian(3) + big_endian(3) + static_cast<char>(bits) + static_cast<char>(kind) + std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + before + chunk("IDAT", stored(rows)) + chunk("IEND", "");
}

double volume(const std::string& bytes) {
    const test_support::TemporaryFolder folder;
    csg::Surface surface;
    surface.file.path = folder.write("picture.png", bytes);
    const auto solid = surface_solid(surface);
    EXPECT_TRUE(solid->warnings.empty()) << solid->warnings[0];
    return test::mesh_volume(solid->points, solid->triangles);
}

TEST(Surface, SamplesOfAPictureAreNumbersNotColors) {
    constexpr double kOfEightBits = 164.5882, kOfColors = 124.3284;  // The latter of the newest (luminance).
    const std::string gamma = chunk("gAMA", big_endian(45455)), linear = chunk("gAMA", big_endian(100000)),
                      srgb = chunk("sRGB", std::string(1, '\0'));
    for (const std::string& space : {std::string(), gamma, linear, srgb}) {
        EXPECT_NEAR(volume(picture(Kind::Gray, 8, space)), kOfEightBits, 1e-3);
        EXPECT_NEAR(volume(picture(Kind::Gray, 16, space)), kOfEightBits, 1e-3);
        EXPECT_NEAR(volume(picture(Kind::GrayAlpha, 8, space)), kOfEightBits, 1e-3);
        EXPECT_NEAR(volume(picture(Kind::GrayAlpha, 16, space)), kOfEightBits, 1e-3);
        EXPECT_NEAR(volume(picture(Kind::Gray, 1, space)), 54, 1e-3);
        EXPECT_NEAR(volume(picture(Kind::Gray, 2, space)), 112.3333, 1e-3);
        EXPECT_NEAR(volume(picture(Kind::Gray, 4, space)), 152.3333, 1e-3);
        EXPECT_NEAR(volume(picture(Kind::Color, 8, space)), kOfColors, 1e-3);
        EXPECT_NEAR(volume(picture(Kind::Color, 16, space)), kOfColors, 1e-3);
    }
    EXPECT_NEAR(volume(picture(Kind::Gray, 8, chunk("tRNS", std::string("\0\x80", 2)))), kOfEightBits, 1e-3);
}

/// The bottom is 1 below the least, not at 0; inverted, white is at -100 + 100/255.
TEST(Surface, BottomOfAPicture) {
    const test_support::TemporaryFolder folder;
    csg::Surface surface;
    surface.file.path = folder.write("picture.png", picture(Kind::Color, 8));
    const auto least = [&] {  // And the least but that.
        double all = 1e9, but_that = 1e9;
        const auto solid = surface_solid(surface);
        for (const glm::dvec3& p : solid->points) {
            all = std::min(all, p.z);
        }
        for (const glm::dvec3& p : solid->points) {
            but_that = p.z > all ? std::min(but_that, p.z) : but_that;
        }
        return std::pair(all, but_that);
    };
    const auto upright = least();
    EXPECT_NEAR(upright.second - upright.first, 1, 1e-9);
    EXPECT_GT(upright.first, 20);
    surface.invert = true;
    const auto inverted = least();
    EXPECT_NEAR(inverted.second - inverted.first, 1, 1e-9);
    EXPECT_LT(inverted.first, -60);
}

TEST(Surface, PalettesCount) {
    std::string colors;
    for (int i = 0; i < 16; ++i) {
        colors += std::string(3, static_cast<char>(i * 16));
    }
    const std::string palette = chunk("PLTE", colors);
    EXPECT_NEAR(volume(picture(Kind::Palette, 4, palette)), 143.6078, 1e-3);
    EXPECT_NEAR(volume(picture(Kind::Palette, 4, palette + chunk("tRNS", std::string("\0\x80", 2)))), 143.6078, 1e-3);
}

/// OpenSCAD takes the upper eight of sixteen bits only.
TEST(Surface, SixteenBitsAreSixteen) {
    const double less = volume(picture(Kind::Gray, 16)) - volume(picture(Kind::Gray, 16, {}, 200));
    EXPECT_GT(less, 0.5);
    EXPECT_LT(less, 4 * 100.0 * 200 / 65535 + 1e-9);
}

}  // namespace
