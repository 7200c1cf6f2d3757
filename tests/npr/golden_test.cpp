// Pictures against goldens. CSGSCOPE_UPDATE_GOLDENS=1 in the environment writes them anew.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "base/file.h"
#include "base/image.h"
#include "tests/npr/golden_tolerance.h"
#include "tests/npr/scene.h"
#include "tests/support/gl_test.h"

namespace {

using csg::Operation;
namespace fs = std::filesystem;

struct Golden {
    const char* name;
    scene::Studio::Request request;
};

/// A rounded block with bores of another color, a pin in one of them, and a translucent plate.
scene::Model subject() {
    csg::Fineness fine;
    fine.fn = 24;
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), glm::radians(90.0), {0, 1, 0});
    return scene::combine(Operation::Union,
                          {scene::colored({0.35F, 0.5F, 0.7F, 1}, scene::widget()),
                           scene::colored({0.8F, 0.45F, 0.2F, 1},
                                          scene::matrix(turned, scene::leaf(csg::Cylinder{24, 2.5, 2.5, true, fine}))),
                           scene::colored({0.3F, 0.7F, 0.3F, 0.4F}, scene::box({-9, -11, -9}, {18, 1, 18}))});
}

std::vector<Golden> goldens() {
    std::vector<Golden> list{
        {"shaded", {.style = "shaded"}},
        {"edges", {.style = "edges"}},
        {"lines", {.style = "lines"}},
        {"gooch", {.style = "gooch"}},
        {"toon", {.style = "toon"}},
        {"hatch", {.style = "hatch"}},
        {"stipple", {.style = "stipple"}},
        {"tech", {.style = "tech"}},
        {"ntone", {.style = "ntone"}},
        {"blueprint_lines", {.style = "blueprint-lines"}},
        {"chalk", {.style = "chalk"}},
        {"strokes", {.style = "strokes"}},
        {"sketch_blueprint", {.style = "sketch-blueprint"}},
        {"edges_smooth", {.style = "edges", .settings = {{"smooth-surfaces", "on"}}}},
        {"blueprint", {.style = "blueprint"}},
        {"blueprint_white", {.style = "blueprint", .settings = {{"ground", "white"}, {"grid", "on"}}}},
        {"xray", {.style = "xray"}},
        {"sketch", {.style = "sketch"}},
        {"sketch_hidden", {.style = "sketch", .settings = {{"hidden", "0.6"}, {"color", "0.2"}, {"strokes", "3"}}}},
        {"sketch_chalk",
         {.style = "sketch", .settings = {{"medium", "chalk"}, {"paper", "#24342f"}, {"ink", "#f4f1e4"}}}},
        {"edges_transparent", {.style = "edges", .transparent_background = true}},
    };
    for (Golden& g : list) {
        g.request.size = {96, 96};
        g.request.samples = 4;
    }
    return list;
}

/// Empty where the picture is the golden, within the tolerance.
std::string difference(const base::Image& image, const base::Image& golden, const golden::Tolerance& tolerance) {
    if (image.width != golden.width || image.height != golden.height) {
        return "of another size";
    }
    int pixels = 0, largest = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            int worst = 0;
            for (int c = 0; c < 4; ++c) {
                worst = std::max(worst, std::abs(image.pixel(x, y)[c] - golden.pixel(x, y)[c]));
            }
            largest = std::max(largest, worst);
            pixels += worst > tolerance.channel ? 1 : 0;
        }
    }
    const double allowed = tolerance.share * image.width * image.height;
    return pixels <= allowed ? ""
                             : fmt::format("{} pixels differ by more than {} (the worst by {}); {:.0f} may", pixels,
                                           tolerance.channel, largest, allowed);
}

class GoldenTest : public test_support::GlTest {};

TEST_P(GoldenTest, PicturesOfAllStyles) {
    const fs::path folder = fs::path(CSGSCOPE_SOURCE_DIR) / "tests/npr/golden";
    const char* update = std::getenv("CSGSCOPE_UPDATE_GOLDENS");
    scene::Studio studio(gl());
    const scene::Model model = subject();
    for (const Golden& g : goldens()) {
        const base::Image image = studio.draw(model, g.request);
        const fs::path file = folder / (std::string(g.name) + ".png");
        if (update && *update == '1') {
            fs::create_directories(folder);
            base::write_file(file, base::encode_png(image));
            continue;
        }
        ASSERT_TRUE(fs::exists(file)) << file;
        const std::string differs = difference(image, base::read_png(file), golden::tolerance(context_->renderer()));
        if (differs.empty()) {
            continue;
        }
        const fs::path actual = fs::path(testing::TempDir()) / (std::string(g.name) + "_actual.png");
        base::write_file(actual, base::encode_png(image));
        ADD_FAILURE() << g.name << ": " << differs << "; see " << actual;
    }
}

TEST(GoldenComparison, TellsPicturesApart) {
    base::Image a{10, 10, std::vector<std::uint8_t>(400, 100)}, b = a;
    const golden::Tolerance tolerance{2, 0.02};
    EXPECT_EQ(difference(a, b, tolerance), "");
    for (std::uint8_t& v : b.rgba) {
        v = 102;
    }
    EXPECT_EQ(difference(a, b, tolerance), "") << "all within the step";
    b = a;
    b.rgba[3] = b.rgba[40] = 200;
    EXPECT_EQ(difference(a, b, tolerance), "") << "two of a hundred pixels";
    b.rgba[80] = 103;
    EXPECT_NE(difference(a, b, tolerance), "");
    EXPECT_NE(difference(a, base::Image{20, 5, a.rgba}, tolerance), "");
}

INSTANTIATE_TEST_SUITE_P(Contexts, GoldenTest, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

}  // namespace
