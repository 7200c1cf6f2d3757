// A style is one file and its shaders: this is one, which the program does not know.
#include <fmt/format.h>

#include "npr/styles/pixel_style.h"
#include "tests/npr/easel.h"
#include "tests/npr/golden_tolerance.h"
#include "tests/support/gl_test.h"
#include "tests/support/temporary_folder.h"

namespace {

struct Bands {
    float spacing{};
    glm::vec3 ink{};

    static const npr::SettingsTable<Bands>& table() {
        static const npr::SettingsTable<Bands> all{
            npr::setting<&Bands::spacing>(npr::Parameter::number("spacing", "Between two bands", 2, 0.5F, 10)),
            npr::setting<&Bands::ink>(npr::Parameter::color("ink", "Color of bands", {0.2F, 0.1F, 0.5F})),
        };
        return all;
    }
};

using namespace glm;  // As shader files do.

struct BandsPixels : npr::shader::Frame, Bands {
    BandsPixels(const npr::CpuFrame& frame, const Bands& bands) : Frame(frame), Bands(bands) {}
#include "tests/npr/own_style.glsl"

    void begin(int /*tile*/) {}
    glm::vec4 pixel(glm::ivec2 p) {
        return bands(p);
    }
    [[nodiscard]] static bool as_left(glm::ivec2 /*p*/) {
        return false;
    }
};

npr::StyleInfo bands_style() {
    static const auto read = [](const char* name) {
        return test_support::read_file(std::filesystem::path(CSGSCOPE_SOURCE_DIR) / name);
    };
    static const std::string shared = read("tests/npr/own_style.glsl"), fragment = read("tests/npr/own_style.frag");
    static const std::array<gl::ShaderFile, 2> files{
        {{"tests/npr/own_style.glsl", shared}, {"tests/npr/own_style.frag", fragment}}};
    return npr::pixel_style<Bands, BandsPixels>(
        {"bands", "Bands", "tests/npr/own_style.frag", [](bool) { return 1; }, files});
}

npr::Picture picture(const npr::StyleInfo& style, const csg::Box& box) {
    npr::Picture picture = npr::default_picture();
    picture.draw_as(style);
    picture.camera = scene::camera(box);
    picture.size = {96, 80};
    picture.samples = 1;
    return picture;
}

class OwnStyle : public test_support::GlTest {};

TEST_P(OwnStyle, IsDrawnByBothPainters) {
    const npr::StyleInfo style = bands_style();
    scene::Easel easel(scene::widget());
    npr::Picture p = picture(style, easel.box());
    const base::Image painted = easel.paint(p);
    EXPECT_LE(scene::differing(painted, easel.draw(gl(), p), golden::tolerance(context_->renderer()).channel), 40);

    // Each parameter reaches both, and so does what is wished of all styles.
    p.parameters.read("spacing", "5");
    const base::Image wider = easel.paint(p);
    EXPECT_GT(scene::differing(wider, painted, 24), 400);
    p.parameters.set("ink", glm::vec3(1, 0, 0));
    EXPECT_GT(scene::differing(easel.paint(p), wider, 24), 400);
    p.transparent_background = true;
    const base::Image clear = easel.paint(p);
    EXPECT_EQ(clear.pixel(0, 0)[3], 0);
    EXPECT_LE(scene::differing(clear, easel.draw(gl(), p), golden::tolerance(context_->renderer()).channel), 40);
}

INSTANTIATE_TEST_SUITE_P(Contexts, OwnStyle, testing::Values(gl::ContextKind::Egl, gl::ContextKind::Osmesa),
                         test_support::context_name);

TEST(Settings, FollowFromTheTable) {
    const auto& table = Bands::table();
    ASSERT_EQ(table.parameters().size(), 2U);
    EXPECT_EQ(table.parameters()[0].name, "spacing");
    EXPECT_EQ(table.declarations(), "uniform float spacing;\nuniform vec3 ink;\n");
    npr::Parameters values(table.parameters());
    EXPECT_EQ(table.settings(values).spacing, 2);
    values.set("spacing", 3.0F);
    EXPECT_EQ(table.settings(values).spacing, 3);
    EXPECT_THROW((void)table.settings(npr::default_picture().parameters), std::logic_error) << "another style's";
}

struct Numbers {
    float as_float{};
    glm::uint as_uint{};
    bool as_bool{};
    glm::vec3 color{};
};
using Table = npr::SettingsTable<Numbers>;
const auto kInteger = npr::Parameter::integer("n", "N", 1, 0, 9);

TEST(Settings, TakeNumbersOfOtherTypesAndNothingElse) {
    const Table table{npr::setting<&Numbers::as_float>(kInteger), npr::setting<&Numbers::as_uint>(kInteger),
                      npr::setting<&Numbers::as_bool>(kInteger), npr::setting<&Numbers::color>()};
    const Numbers all = table.settings(npr::Parameters(table.parameters()));
    EXPECT_EQ(all.as_float, 1);
    EXPECT_EQ(all.as_uint, 1U);
    EXPECT_TRUE(all.as_bool);
    EXPECT_EQ(table.declarations(),
              "uniform float as_float;\nuniform uint as_uint;\nuniform bool as_bool;\nuniform vec3 color;\n");
    EXPECT_THROW((Table{npr::setting<&Numbers::color>(kInteger)}), std::logic_error);
    EXPECT_THROW((Table{npr::setting<&Numbers::as_float>(npr::Parameter::color("c", "C", {0, 0, 0}))}),
                 std::logic_error);
}

}  // namespace
