// Styles of parts (--style-of), as users ask for them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "base/image.h"
#include "tests/support/program_test.h"

namespace {

/// Half-open ranges of columns and rows.
struct Area {
    int left, top, right, bottom;
};
constexpr Area kAll{0, 0, 120, 90};

class PartStyles : public test_support::ProgramTest {
  protected:
    PartStyles() : ProgramTest(60) {}

    /// Seen from the front: `near` at the left before `far`, which reaches to the right; `apart` at the right border.
    void write_blocks() {
        folder_.write("blocks.scad",
                      "module near() color(\"gold\") translate([-20, -20, -8]) cube([20, 6, 16]);\n"
                      "module far() color(\"teal\") translate([-12, 10, -12]) cube([30, 6, 24]);\n"
                      "module apart() color(\"tomato\") translate([26, 0, -10]) cube([8, 8, 20]);\n"
                      "near(); far(); apart();\n");
    }
    [[nodiscard]] base::Image drawn(const std::string& options) const {
        const Result result =
            run("blocks.scad -o p.png -q --imgsize 120,90 --projection o "
                "--camera=8,0,0,90,0,0,150 --context none " +
                options);
        EXPECT_EQ(result.status, 0) << result.err;
        return base::read_png(folder_.path("p.png"));
    }
    /// Pixels within the area that differ by more than `step`.
    static int differing(const base::Image& a, const base::Image& b, const Area& area, int step = 0) {
        int count = 0;
        for (int y = area.top; y < area.bottom; ++y) {
            for (int x = area.left; x < area.right; ++x) {
                bool same = true;
                for (int c = 0; c < 4; ++c) {
                    same = same && std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]) <= step;
                }
                count += same ? 0 : 1;
            }
        }
        return count;
    }
};

TEST_F(PartStyles, OfEveryStyleTheSameForAPartIsThatOfThePicture) {
    write_blocks();
    for (const char* style : {"shaded", "edges", "lines", "gooch", "toon", "xray"}) {
        const base::Image plain = drawn(fmt::format("--parts top --style {}", style));
        const base::Image parted = drawn(fmt::format("--style {0} --style-of 'part=near: {0}'", style));
        // Lines that bound two parts are those of one of them alone, and strengths are by its own layers.
        EXPECT_LE(differing(plain, parted, kAll, 2), std::string(style) == "xray" ? 160 : 70) << style;
        const base::Image all = drawn(fmt::format("--parts model --style shaded --style-of 'part=model: {}'", style));
        const base::Image whole = drawn(fmt::format("--style {}", style));
        EXPECT_EQ(differing(all, whole, std::string(style) == "lines" ? Area{20, 40, 60, 50} : kAll, 1), 0) << style;
    }
}

TEST_F(PartStyles, AGhostChangesNoPixelOfAnother) {
    write_blocks();
    const base::Image plain = drawn("--parts top --style edges");
    for (const char* ghost : {"xray", "xray,opacity=0", "blueprint", "sketch", "gooch,width=4"}) {
        // Where it is not, not even behind.
        EXPECT_EQ(
            differing(plain, drawn(fmt::format("--style edges --style-of 'part=near: {}'", ghost)), {70, 0, 120, 90}),
            0)
            << ghost;
        // A ghost that another hides.
        const base::Image behind = drawn(fmt::format("--style edges --style-of 'part=far: {}'", ghost));
        EXPECT_EQ(differing(plain, behind, {31, 38, 44, 52}), 0) << ghost;
        EXPECT_GT(differing(plain, behind, {56, 38, 70, 52}), 100) << ghost;
    }
}

TEST_F(PartStyles, WhatAGhostHidIsSeenThroughIt) {
    write_blocks();
    const base::Image plain = drawn("--parts top"), alone = drawn("--parts top -D 'module near() {}'");
    ASSERT_GT(differing(plain, alone, {32, 38, 45, 52}), 100);
    const base::Image clear = drawn("--style-of 'part=near: xray,opacity=0,edges=0,inner=0'");
    EXPECT_EQ(differing(clear, alone, kAll, 1), 0);
    const base::Image ghost = drawn("--style-of 'module=near: xray,opacity=0.5'");
    EXPECT_GT(differing(ghost, alone, {32, 38, 45, 52}), 100);
    EXPECT_GT(differing(ghost, plain, {32, 38, 45, 52}), 100);
    EXPECT_EQ(differing(drawn("--style-of 'color=gold: xray,opacity=0.5'"), ghost, kAll), 0);
}

TEST_F(PartStyles, BackgroundPartsLieBetween) {
    folder_.write("blocks.scad",
                  "module near() translate([-20, -20, -8]) cube([20, 6, 16]);\n"
                  "near(); %translate([-30, -10, -20]) cube([60, 4, 40]);\n"
                  "color(\"teal\") translate([-12, 10, -12]) cube([30, 6, 24]);\n");
    const base::Image plain = drawn("--parts top");
    EXPECT_EQ(differing(plain, drawn("--style-of 'part=near: edges,inner=0'"), {54, 0, 120, 90}), 0);
    EXPECT_EQ(differing(plain, drawn("--style-of 'color=teal: shaded'"), kAll, 1), 0);
}

TEST_F(PartStyles, TheLastStyleOfAPartHolds) {
    write_blocks();
    EXPECT_EQ(differing(drawn("--style-of 'part=far: xray' --style-of 'part=far: toon'"),
                        drawn("--style-of 'part=far: toon'"), kAll),
              0);
}

TEST_F(PartStyles, OpenGlMayMakeTheLayers) {
    write_blocks();
    const std::string style = "--style edges --style-of 'part=near: xray'";
    const base::Image cpu = drawn(style), opengl = drawn(style + " --context osmesa --engine goldfeather");
    EXPECT_LE(differing(cpu, opengl, kAll, 2), 60);
}

TEST_F(PartStyles, WhatIsWrongIsTold) {
    write_blocks();
    const auto error = [&](const std::string& options) {
        const Result result = run("blocks.scad -o p.png " + options);
        EXPECT_EQ(result.status, 1) << options;
        return result.err;
    };
    const auto tells = [&](const std::string& options, const std::string& what) {
        EXPECT_NE(error(options).find(what), std::string::npos) << options;
    };
    tells("--style-of 'part=naer: xray'", "no part \"naer\". Did you mean \"near\"?");
    tells("--style-of 'module=neer: xray'", "neer");
    tells("--style-of 'color=#123456: xray'", "no part \"#123456\"");
    tells("--style-of 'color=blau: xray'", "no color \"blau\"");
    tells("--style-of 'part=near: xrey'", "Did you mean \"xray\"?");
    tells("--style-of 'part=near: xray,opacty=1'", "did you mean \"opacity\"?");
    tells("--style-of 'part=near: xray,opacity=7'", "opacity takes a number from 0 to 1");
    tells("--style-of 'part=near: xray,opacity'", "expected PARAMETER=VALUE");
    tells("--style-of 'near: xray'", "part=NAME");
    tells("--style-of 'part=: xray'", "which part?");
    tells("--style-of near", "expected 'part=NAME");
}

TEST_F(PartStyles, WhatHidesARevealedPartIsPeeledAway) {
    write_blocks();
    const auto peeled = [&](const std::string& reveal) {
        (void)drawn(fmt::format("--stats s.json {}", reveal));
        const std::string json = folder_.read("s.json");
        const std::size_t at = json.find("\"peeled_away\":");
        return at == std::string::npos ? -1 : std::atoi(json.c_str() + at + 14);
    };
    EXPECT_EQ(peeled("--reveal near"), 0) << "nothing is before it";
    EXPECT_EQ(peeled("--reveal far"), 2) << "a front and a back of what is before a part of it";
    EXPECT_EQ(peeled("--reveal far,0.5"), 0) << "half of it is seen as it is";
    EXPECT_EQ(peeled("--reveal module=apart --reveal module=far"), 2);
    const base::Image alone = drawn("--parts top -D 'module near() {}'"), revealed = drawn("--reveal far");
    EXPECT_EQ(differing(alone, revealed, {31, 38, 44, 52}, 1), 0);
    EXPECT_EQ(differing(drawn("--reveal far --style-of 'part=far: edges'"), revealed, {32, 40, 44, 50}, 1), 0);
    EXPECT_EQ(run("blocks.scad -o p.png --reveal farr").status, 1);
    EXPECT_NE(run("blocks.scad -o p.png --reveal farr").err.find("Did you mean \"far\"?"), std::string::npos);
    EXPECT_EQ(run("blocks.scad -o p.png --reveal far,2").status, 1);
    EXPECT_EQ(run("blocks.scad -o p.png --reveal far,").status, 1);
}

}  // namespace
