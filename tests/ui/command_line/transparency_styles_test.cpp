// Models of transparency beside styles (--style), styles of parts (--style-of) and what is peeled away (--reveal).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "base/image.h"
#include "npr/style.h"
#include "tests/support/program_test.h"

namespace {

class TransparencyStyles : public test_support::ProgramTest {
  protected:
    TransparencyStyles() : ProgramTest(60) {
        folder_.write("glass.scad",
                      "module bolt() color(\"gold\") translate([0, 0, -14]) cylinder(h = 28, r = 4, $fn = 24);\n"
                      "module inner() color(\"teal\", 0.4) translate([-9, -9, -9]) cube([14, 18, 18]);\n"
                      "module outer() color(\"tomato\", 0.5) translate([-12, -12, -12]) cube([24, 24, 24]);\n"
                      "bolt(); inner(); outer();\n");
        folder_.write("balls.scad",
                      "color(\"gold\") cube(7, center = true);\n"
                      "color(\"teal\", 0.4) sphere(8, $fn = 24);\n"
                      "color(\"tomato\", 0.5) sphere(12, $fn = 24);\n"
                      "%translate([14, 0, 0]) sphere(3, $fn = 16);\n");
        folder_.write("crossing.scad",
                      "color(\"teal\", 0.5) cube([30, 6, 10], center = true);\n"
                      "color(\"tomato\", 0.5) rotate([10, 20, 60]) cube([30, 6, 10], center = true);\n"
                      "color(\"gold\") cube(5);\n");
    }
    [[nodiscard]] base::Image drawn(const std::string& options) const {
        const Result result = run("-o p.png -q --imgsize 96,72 --samples 1 --viewall --autocenter " + options);
        EXPECT_EQ(result.status, 0) << options << result.err;
        return base::read_png(folder_.path("p.png"));
    }
    /// Pixels that differ by more than `step`.
    static int differing(const base::Image& a, const base::Image& b, int step = 0) {
        int count = 0;
        for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
            bool same = true;
            for (std::size_t c = i; c < i + 4; ++c) {
                same = same && std::abs(a.rgba[c] - b.rgba[c]) <= step;
            }
            count += same ? 0 : 1;
        }
        return count;
    }
};

TEST_F(TransparencyStyles, AreOfTheStylesThatSayIt) {
    for (const npr::StyleInfo& style : npr::styles()) {
        const auto picture = [&](const char* model) {
            return drawn(fmt::format("glass.scad --style {} --transparency {}", style.name, model));
        };
        const base::Image exact = picture("exact");
        const bool follows = npr::follows_transparency(style);
        EXPECT_EQ(differing(picture("volume"), exact) > 0, follows) << style.name;
        const std::string said =
            run(fmt::format("glass.scad -o a.png --imgsize 8,8 --style {} --transparency volume", style.name)).err;
        EXPECT_EQ(said.find("--transparency volume changes nothing") == std::string::npos, follows) << said;
        EXPECT_EQ(differing(picture("screen-door"), exact) > 0, follows) << style.name;
        EXPECT_EQ(differing(picture("sorted:src=one,dst=one"), exact) > 0, follows) << style.name;
    }
}

/// Where nothing crosses, sorting triangles is right; so the picture is that of the layers. Triangles are flat: where
/// layers are shaded smoothly they are not.
TEST_F(TransparencyStyles, SortedIsThatOfTheLayersInEveryStyleWhereNothingCrosses) {
    for (const npr::StyleInfo& style : npr::styles()) {
        std::string options = fmt::format("balls.scad --style {}", style.name);
        for (const npr::Parameter& p : style.parameters) {
            if (p.name == "smooth" && p.label == "Smooth shading") {
                options += " --set smooth=off";
            }
        }
        const base::Image exact = drawn(options), sorted = drawn(options + " --transparency sorted");
        EXPECT_LE(differing(sorted, exact, 2), 60) << style.name;
    }
}

TEST_F(TransparencyStyles, SortedShadedIsTheSameByLayers) {
    // What is revealed is peeled from layers: without that, and with a share that needs none peeled.
    for (const char* settings : {"sorted", "sorted:depth=on,order=none", "sorted:back-faces=on", "sorted:order=parts",
                                 "sorted:src=dst-color,dst=zero"}) {
        const std::string options = fmt::format("crossing.scad --transparency {}", settings);
        const base::Image plain = drawn(options), layered = drawn(options + " --style-of 'color=gold: shaded'");
        EXPECT_LE(differing(plain, layered, 1), 12) << settings;
    }
}

TEST_F(TransparencyStyles, SortedIsTheSameByEitherContext) {
    for (const char* style : {"shaded", "edges", "toon"}) {
        const std::string options = fmt::format("crossing.scad --transparency sorted --style {}", style);
        const base::Image cpu = drawn(options + " --context none");
        EXPECT_TRUE(drawn(options + " --engine goldfeather --context osmesa").rgba == cpu.rgba) << style;
    }
}

TEST_F(TransparencyStyles, OfPartsAreThatOfThePicture) {
    for (const char* model :
         {"exact", "volume", "view-dependent", "view-dependent:opacity=vertices", "screen-door", "sorted"}) {
        for (const char* style : {"shaded", "edges"}) {
            const std::string options =
                fmt::format("glass.scad --parts top --style {} --transparency {}", style, model);
            const base::Image plain = drawn(options);
            const base::Image parted = drawn(options + fmt::format(" --style-of 'color=teal: {}'", style));
            // Lines that bound two parts are those of one of them alone.
            EXPECT_LE(differing(parted, plain, 1), style == std::string("shaded") ? 12 : 600) << model << style;
        }
    }
}

TEST_F(TransparencyStyles, OfPartsAreSeenThroughOtherStyles) {
    for (const char* model : {"volume", "view-dependent", "screen-door", "sorted"}) {
        const std::string options = fmt::format("glass.scad --style shaded --transparency {}", model);
        const base::Image toon = drawn(options + " --style-of 'part=bolt: toon'");
        const base::Image plain = drawn(options + " --parts top");
        EXPECT_GT(differing(toon, plain, 8), 20) << model << ": the bolt is another";
        EXPECT_LT(differing(toon, plain, 8), 96 * 72 / 2) << model << ": the rest is not";
    }
}

TEST_F(TransparencyStyles, WhatHidesARevealedPartIsPeeledAway) {
    folder_.write("box.scad",
                  "module core() color(\"gold\") cube(6, center = true);\n"
                  "module shell() color(\"teal\") difference() { cube(20, center = true); cube(16, center = true); }\n"
                  "module haze() color(\"tomato\", 0.5) translate([0, 0, 1]) cube(12, center = true);\n"
                  "core(); shell(); haze();\n");
    for (const char* model : {"exact", "volume", "view-dependent", "screen-door", "sorted"}) {
        const std::string options = fmt::format("box.scad --parts top --transparency {}", model);
        const base::Image hidden = drawn(options), seen = drawn(options + " --reveal core");
        const auto middle = seen.pixel(48, 36), before = hidden.pixel(48, 36);
        EXPECT_TRUE(middle != before) << model;
        EXPECT_GT(middle[0] - middle[2], before[0] - before[2]) << model << ": of gold, not of teal";
    }
    // Of a medium that is peeled away nothing is left, neither before nor about the core.
    folder_.write("media.scad",
                  "module core() color(\"gold\") cube(6, center = true);\n"
                  "module haze() color(\"black\", 0.9) cube(12, center = true);\n"
                  "module shell() color(\"teal\") cube([20, 20, 1]);\n"
                  "core(); haze(); translate([-10, -10, 9]) shell();\n");
    const std::string options = "media.scad --parts top --transparency volume --camera=0,0,0,0,0,0,60 --projection o ";
    EXPECT_GT(drawn(options + "--reveal core").pixel(48, 36)[0], drawn(options).pixel(48, 36)[0]);
}

/// Of two opaque parts with a common face one is seen, the same one.
TEST_F(TransparencyStyles, CoincidentOpaquePartsLookTheSameInAnyOrder) {
    const std::string a = "color(\"red\") cube([12, 12, 4]);",
                      b = "color(\"blue\") translate([4, 4, 2]) cube([12, 12, 2]);",
                      c = "difference() { translate([-4, 6, 0]) cube([14, 5, 8]); translate([-9, 0, 4]) cube(40); }",
                      d = "color(\"green\", 0.5) translate([8, -3, 1]) cube([4, 12, 3]);";
    folder_.write("1.scad", a + b + c + d);
    folder_.write("2.scad", d + c + b + a);
    folder_.write("3.scad", c + a + d + b);
    using Pair = std::pair<const char*, const char*>;
    for (const auto& [style, engine] :
         {Pair("shaded", "lists-cpu"), Pair("edges", "lists-cpu"), Pair("blueprint", "lists-cpu"),
          Pair("edges", "lists"), Pair("edges", "goldfeather")}) {
        const std::string options = fmt::format(" --parts top --style {} --engine {}{}", style, engine,
                                                std::string_view(engine) == "lists-cpu" ? "" : " --context osmesa");
        const base::Image expected = drawn("1.scad" + options);
        EXPECT_TRUE(drawn("2.scad" + options).rgba == expected.rgba) << style << engine;
        EXPECT_TRUE(drawn("3.scad" + options).rgba == expected.rgba) << style << engine;
    }
}

}  // namespace
