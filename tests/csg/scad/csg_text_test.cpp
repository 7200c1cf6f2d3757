// The .csg text: numbers as streams print them, and text in pieces; random numbers.
#include "csg/scad/text/csg_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "csg/scad/builtin/seeded_random.h"
#include "csg/scad/value/number_text.h"
#include "tests/csg/scad/evaluate_text.h"

namespace {

std::string text_of(double number) {
    std::string text;
    csg::scad::append_number(text, number);
    return text;
}

void expect_as_streams_do(double number) {
    ASSERT_EQ(text_of(number), fmt::format("{:g}", number)) << fmt::format("{:a}", number);
}

TEST(NumberText, IsThatOfStreams) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponents(-7, 9);
    for (int i = 0; i < 50'000; ++i) {
        const double size = std::pow(10.0, exponents(random));
        const double number = (random() & 1U) != 0 ? size : -size;
        expect_as_streams_do(number);
        expect_as_streams_do(std::round(number * 1000) / 1000);
        expect_as_streams_do(std::round(number * 2) / 2);
        expect_as_streams_do(std::floor(number * 1e5) / 1e5 + 5e-6);  // Often half a unit of the sixth digit.
    }
}

TEST(NumberText, RoundsTiesAndCarriesAsStreamsDo) {
    for (int i = -70'000; i < 70'000; ++i) {
        expect_as_streams_do(i);
        expect_as_streams_do(i / 64.0);
        expect_as_streams_do(99'999 + i / 65'536.0);
    }
    for (const double number : {0.0, -0.0, 999999.5, 999999.4999, 1e6, 0.0001, 0.00009999995, 0.1, 0.999999, 0.9999995,
                                std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()}) {
        expect_as_streams_do(number);
        expect_as_streams_do(-number);
    }
}

TEST(CsgText, ComesInPiecesOfBoundedSize) {
    const test::Run run = test::run("for (i = [0:9999]) translate([i, 0, 0]) cube(1);");
    ASSERT_TRUE(run.evaluation.ok) << run.console;
    std::string text;
    std::size_t pieces = 0;
    csg::scad::write_csg(*run.evaluation.tree, [&](std::string_view piece) {
        EXPECT_LT(piece.size(), std::size_t{1} << 17);
        text += piece;
        ++pieces;
    });
    EXPECT_GT(pieces, 5U);
    EXPECT_EQ(text, run.csg);
    EXPECT_NE(text.find("multmatrix([[1, 0, 0, 9999], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n\t\tcube("),
              std::string::npos);
}

TEST(SeededRandom, HasTheSequenceOfTheStandard) {
    for (const std::uint32_t seed : {0U, 1U, 5489U, 4294967295U, 123456U}) {
        std::mt19937 expected(seed);
        csg::scad::SeededRandom random;
        random.seed(seed);
        for (int i = 0; i < 2000; ++i) {
            ASSERT_EQ(random(), expected()) << seed << " at " << i;
        }
    }
}

TEST(SeededRandom, IsTheSameForSeedsThatComeAgain) {
    csg::scad::SeededRandom random;
    for (const int count : {1, 5, 6, 7, 400, 2000, 3}) {
        for (const std::uint32_t seed : {7U, 7U + 512U, 7U, 0U}) {
            std::mt19937 expected(seed);
            random.seed(seed);
            for (int i = 0; i < count; ++i) {
                ASSERT_EQ(random(), expected()) << seed << " at " << i << " of " << count;
            }
        }
    }
}

}  // namespace
