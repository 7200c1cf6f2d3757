// View-dependent transparency: each rule of Diepstraten, Weiskopf and Ertl (2002) in a picture.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "npr/shine/shine.h"
#include "npr/shine/vertex_shine.h"
#include "npr/shine/view_dependent_settings.h"
#include "tests/npr/easel.h"

namespace {

using csg::Operation;
using npr::Transparency;
using scene::box;
using scene::colored;
using scene::Easel;
using scene::Model;

constexpr csg::Rgba kGlass{0.2F, 0.8F, 0.4F, 0.3F}, kOther{0.9F, 0.3F, 0.2F, 0.6F}, kSteel{0.3F, 0.4F, 0.6F, 1};
constexpr int kSide = 64;
/// Of the floor that all scenes stand on, a pixel each; seen from above.
constexpr double kFloor = 64;

Model all(std::vector<Model> models) {
    return scene::combine(Operation::Union, std::move(models));
}

/// On a floor that the picture is all of, one unit a pixel. Without falloff, and with nothing that hides: what is clear
/// is all clear.
npr::Picture picture(std::string_view until = "front-face") {
    npr::Picture p;
    p.draw_as(*npr::find_style("shaded"));
    p.scheme = npr::color_schemes().front();
    p.camera.projection = base::Projection::Orthographic;
    p.camera.rotation = {0, 0, 0};
    p.camera.distance = 0.5 * kFloor / std::tan(0.5 * p.camera.fov * std::acos(-1.0) / 180);
    p.size = {kSide, kSide};
    p.samples = 1;
    p.see_through_as(*npr::find_transparency("view-dependent"));
    for (const char* setting : {"falloff", "silhouettes"}) {
        p.transparency_parameters.read(setting, "0");
    }
    p.transparency_parameters.read("gooch", "off");
    p.transparency_parameters.read("until", until);
    return p;
}

using Pixel = std::array<std::uint8_t, 3>;

Pixel middle(const Model& model, const npr::Picture& p, int x = kSide / 2, int y = kSide / 2) {
    const base::Image image = Easel(model).paint(p);
    const auto c = image.pixel(x, y);
    return {c[0], c[1], c[2]};
}

const Model kBlock = colored(kSteel, box({-6, -6, 0}, {12, 12, 4}));
const Model kPane = colored(kGlass, box({-20, -20, 10}, {40, 40, 2}));
const Model kBelow = colored(kGlass, box({-20, -20, -20}, {40, 40, 2}));

TEST(ViewDependent, OpaquePartsShowUpToTheFirstBackFaceOrTheSecondFrontFace) {
    const Pixel block = middle(kBlock, picture()), nothing = middle(kPane, picture());
    const Model behind = all({kBlock, kPane}),
                within = all({kBlock, colored(kGlass, box({-20, -20, -5}, {40, 40, 20}))});
    EXPECT_EQ(middle(behind, picture("front-face")), block) << "II: walls are modeled";
    EXPECT_EQ(middle(behind, picture("back-face")), nothing) << "I: behind the body";
    EXPECT_EQ(middle(within, picture("front-face")), block);
    EXPECT_EQ(middle(within, picture("back-face")), block);
    // A hollow body, which has a wall behind the block, too: a second front face behind it hides nothing before it.
    const Model hollow =
        scene::combine(Operation::Difference, {box({-20, -20, -10}, {40, 40, 24}), box({-18, -18, -8}, {36, 36, 20})});
    EXPECT_EQ(middle(all({kBlock, colored(kGlass, hollow)}), picture("front-face")), block);
    EXPECT_EQ(middle(all({kBlock, colored(kGlass, hollow)}), picture("back-face")), nothing);
    // Beyond the wall behind it is hidden.
    const Model far = colored(kSteel, box({-6, -6, -30}, {12, 12, 4}));
    EXPECT_EQ(middle(all({far, colored(kGlass, hollow)}), picture("front-face")), nothing);
}

TEST(ViewDependent, OpaquePartsShowThroughTheNearestFaceOnly) {
    const Model above = colored(kOther, box({-20, -20, 20}, {40, 40, 2}));
    for (const char* until : {"front-face", "back-face"}) {
        EXPECT_EQ(middle(all({kBlock, kPane, above}), picture(until)), middle(above, picture(until))) << until;
        // A body within a body.
        const Model outer = colored(kOther, box({-30, -30, -20}, {60, 60, 60}));
        const Model inner = colored(kGlass, box({-20, -20, -10}, {40, 40, 40}));
        EXPECT_EQ(middle(all({kBlock, inner, outer}), picture(until)), middle(outer, picture(until))) << until;
    }
    EXPECT_EQ(middle(all({colored(kSteel, box({-6, -6, 30}, {12, 12, 4})), above, kPane}), picture()),
              middle(kBlock, picture()))
        << "what is before all of them";
}

TEST(ViewDependent, NothingThatIsSeenThroughShowsThroughAnother) {
    const base::Image one = Easel(kPane).paint(picture());
    EXPECT_EQ(scene::differing(Easel(all({kPane, kBelow})).paint(picture()), one, 0), 0);
    EXPECT_EQ(scene::differing(
                  Easel(all({kPane, colored(kOther, box({-19, -19, -20}, {38, 38, 25}))})).paint(picture()), one, 0),
              0);
}

TEST(ViewDependent, OnlyFacesTowardTheEyeShine) {
    // The eye is inside of the body, whose far side is behind the block.
    npr::Picture p = picture();
    p.camera.projection = base::Projection::Perspective;
    p.camera.distance = 40;
    const Model around = colored(kGlass, box({-50, -50, -50}, {100, 100, 200}));
    const Model floor = colored(kSteel, box({-80, -80, -80}, {160, 160, 2}));
    EXPECT_EQ(middle(all({kBlock, floor, around}), p), middle(all({kBlock, floor}), p));
    EXPECT_EQ(middle(all({kBlock, floor, around}), p, 2, 2), middle(all({kBlock, floor}), p, 2, 2));
}

TEST(ViewDependent, WeightsAreOfTheBackgroundAndOfOpaqueParts) {
    npr::Picture p = picture();
    const auto share = [&](const Model& model, const glm::vec3& behind) {
        // Which share of what is behind does the pane's middle show, in red?
        p.transparency_parameters.read("opaque", "0");
        p.transparency_parameters.read("background", "0");
        const double glass = middle(kPane, p)[0];
        p.transparency_parameters.read("opaque", "0.75");
        p.transparency_parameters.read("background", "0.25");
        return (middle(model, p)[0] - glass) / (255.0 * behind.r - glass);
    };
    const Model white = colored({1, 1, 1, 1}, box({-6, -6, 0}, {12, 12, 4}));
    const double lit = middle(white, p)[0] / 255.0;
    EXPECT_NEAR(share(kPane, p.scheme.background), 0.25, 0.01);
    EXPECT_NEAR(share(all({kPane, white}), glm::vec3(static_cast<float>(lit))), 0.75, 0.02);
}

TEST(ViewDependent, OpacityFallsFromSilhouettesByTheFormula) {
    npr::Picture p = picture();
    p.transparency_parameters.read("background", "1");
    const Model pane = colored({0, 0, 0, 0.5F}, box({-20, -12, 0}, {40, 24, 2}));
    const double radius = std::sqrt(20 * 20 + 12 * 12 + 1);
    for (const char* falloff : {"0.25", "0.5", "1"}) {
        p.transparency_parameters.read("falloff", falloff);
        const base::Image image = Easel(pane).paint(p);
        for (int y = 20; y < 44; ++y) {
            for (int x = 12; x < 52; ++x) {
                const int away = std::min({x - 12, 51 - x, y - 20, 43 - y});
                const double clear = std::pow(away / radius, std::stod(falloff));
                EXPECT_NEAR(image.pixel(x, y)[0], 255 * clear * p.scheme.background.r, 1) << x << ", " << y;
            }
        }
    }
}

/// A pyramid of four sides seen from above: its base is the silhouette, and its apex as clear as it is far from there.
TEST(ViewDependent, OpacityByVertexIsInProportionBetweenVertices) {
    constexpr double kHalf = 20, kHeight = 15, kRadius = 30;
    npr::ColoredMesh mesh;
    mesh.points = {{-kHalf, -kHalf, 0}, {kHalf, -kHalf, 0}, {kHalf, kHalf, 0}, {-kHalf, kHalf, 0}, {0, 0, kHeight}};
    mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 1}, {0, 3, 2}};
    mesh.parts.assign(6, 1);
    layers::PartLook look;
    look.radius = static_cast<float>(kRadius);
    const std::vector<layers::PartLook> parts(2, look);
    const base::View view(picture().camera, {kSide, kSide}, {-20, -20, 0}, {20, 20, 15});
    std::vector<npr::ShineSource> sources(kSide * kSide, {0, 1, (1U + 1U) << 1U, 0});
    sources[kSide * 32 + 40].front_key = 1U << 1U;  // Another part's.
    const std::vector<float> clear = npr::clearness_by_vertex(mesh, view, parts, 0.5F, sources);
    const double apex = std::sqrt(std::hypot(kHalf, kHeight) / kRadius);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double away = std::max(std::abs(x + 0.5 - 32), std::abs(y + 0.5 - 32)) / kHalf;
            const bool other = x == 40 && y == 32;
            EXPECT_NEAR(clear[static_cast<std::size_t>(kSide * y + x)], other ? 0 : apex * std::max(1 - away, 0.0),
                        1e-5)
                << x << ", " << y;
        }
    }
}

TEST(ViewDependent, DistancesAreExact) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 30; ++trial) {
        const glm::ivec2 size(1 + static_cast<int>(random() % 40), 1 + static_cast<int>(random() % 30));
        std::vector<glm::uint> keys(static_cast<std::size_t>(size.x * size.y));
        for (glm::uint& key : keys) {
            const auto part = static_cast<glm::uint>(random() % 4);
            key = part == 0 ? 0 : part << 1U | (random() % 12 == 0 ? 1U : 0U);
        }
        const std::vector<float> distances = npr::silhouette_distances(size, keys);
        for (int i = 0; i < size.x * size.y; ++i) {
            double nearest = -1;
            const glm::uint key = keys[static_cast<std::size_t>(i)];
            for (int j = 0; j < size.x * size.y && key != 0; ++j) {
                if (keys[static_cast<std::size_t>(j)] == (key | 1U)) {
                    const double d = std::hypot(i % size.x - j % size.x, i / size.x - j / size.x);
                    nearest = nearest < 0 ? d : std::min(nearest, d);
                }
            }
            EXPECT_FLOAT_EQ(distances[static_cast<std::size_t>(i)], static_cast<float>(nearest));
        }
    }
}

TEST(ViewDependent, SilhouettesAreBlackAndShadesCoolToWarm) {
    npr::Picture p = picture();
    p.transparency_parameters.read("silhouettes", "1");
    const Model model = all({kBlock, kPane});
    const base::Image lined = Easel(model).paint(p);
    EXPECT_EQ(lined.pixel(12, 32)[0], 0) << "the pane's";
    EXPECT_EQ(lined.pixel(26, 32)[0], 0) << "the block's";
    EXPECT_GT(lined.pixel(32, 32)[0], 0);
    p.transparency_parameters.read("silhouettes", "0");
    p.transparency_parameters.read("gooch", "on");
    const Model gray = colored({0.5F, 0.5F, 0.5F, 1}, scene::leaf(csg::Sphere{20, {}}));
    const base::Image toned = Easel(gray).paint(p);
    const auto warm = toned.pixel(24, 24), cool = toned.pixel(44, 44);
    EXPECT_GT(warm[0], warm[2]);
    EXPECT_GT(cool[2], cool[0]);
}

}  // namespace
