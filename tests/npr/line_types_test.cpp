// Lines drawn by their types, and dashes that lie on the model.
#include "npr/edges/line_types.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "npr/painter/cpu_ink.h"
#include "tests/npr/easel.h"

namespace {

using npr::LinedSettings;
using npr::LineKind;
using npr::LineType;
using npr::Visibility;

npr::Picture picture_of(const csg::Box& box, glm::ivec2 size) {
    npr::Picture picture;
    picture.camera = scene::camera(box);
    picture.size = size;
    picture.samples = 1;
    return picture;
}

LinedSettings settings_with(bool dashes) {
    LinedSettings settings;
    settings.width = 2;
    settings.hidden_share = 0.75F;
    settings.inner_strength = 0.6F;
    settings.profile_strength = 0.9F;
    settings.dashes = dashes;
    settings.complete_lines(picture_of({{0, 0, 0}, {1, 1, 1}}, {100, 100}));
    return settings;
}

TEST(LineTypes, AskForFactsOnlyWhereTheyTellMore) {
    LinedSettings plain = settings_with(false);
    EXPECT_FALSE(plain.facts);
    EXPECT_EQ(plain.types, npr::plain_types(plain));
    EXPECT_EQ(plain.types.of(LineKind::Silhouette, Visibility::Visible), (LineType{1, 0.9F, 0, 0}));
    EXPECT_EQ(plain.types.of(LineKind::Crease, Visibility::DeeplyHidden), (LineType{0.75F, 0.6F, 0, 0}));
    LinedSettings dashed = settings_with(true);
    EXPECT_TRUE(dashed.facts);
    EXPECT_EQ(dashed.types.of(LineKind::PartBorder, Visibility::Visible),
              plain.types.of(LineKind::PartBorder, Visibility::Visible));
    EXPECT_GT(dashed.types.of(LineKind::PartBorder, Visibility::Hidden).dash,
              dashed.types.of(LineKind::PartBorder, Visibility::DeeplyHidden).dash);
}

TEST(LineTypes, ATableRowIsOfItsKindAndVisibility) {
    npr::LineTypes types;
    types.of(LineKind::Intersection, Visibility::Hidden).strength = 0.25F;
    npr::shader::LineCode code;
    npr::LineFacts facts = code.no_facts();
    facts.kind = code.kIntersection;
    const auto strength = [&](int solids) {
        facts.solids = solids;
        return types.rows[static_cast<std::size_t>(code.type_of_line(facts))].strength;
    };
    EXPECT_EQ(strength(0), 1);
    EXPECT_EQ(strength(1), 0.25F);
    EXPECT_EQ(strength(7), 1);
}

TEST(LineTypes, PatternsInMillimetersAreThoseOfIso128) {
    npr::Picture picture = picture_of({{0, 0, 0}, {1, 1, 1}}, {100, 100});
    picture.draw_as(*npr::find_style("blueprint"));
    picture.parameters.read("width", "0.5mm");
    LinedSettings settings;
    settings.width = 6;
    settings.dashes = true;
    settings.complete_lines(picture);
    const LineType hidden = settings.types.of(LineKind::Crease, Visibility::Hidden),
                   deep = settings.types.of(LineKind::Crease, Visibility::DeeplyHidden);
    EXPECT_FLOAT_EQ(hidden.dash, 12 * 3);
    EXPECT_FLOAT_EQ(hidden.gap, 3 * 3);
    EXPECT_FLOAT_EQ(deep.dash, 0.5F * 3);
    EXPECT_FLOAT_EQ(deep.gap, 3 * 3);
}

TEST(LineTypes, EdgesOfCutsAreTheWidest) {
    npr::Picture picture = picture_of({{0, 0, 0}, {1, 1, 1}}, {100, 100});
    picture.sections.cuts.push_back({npr::PlaneSection(), "z=0"});
    LinedSettings settings;
    settings.width = 2;
    settings.section_share = 1.5F;
    settings.complete_lines(picture);
    EXPECT_TRUE(settings.facts);
    const auto pixels = [&](LineKind kind) {
        return settings.width * settings.types.of(kind, Visibility::Visible).width;
    };
    EXPECT_FLOAT_EQ(pixels(LineKind::SectionEdge), 3);
    EXPECT_FLOAT_EQ(pixels(LineKind::Silhouette), 2);
    EXPECT_FLOAT_EQ(pixels(LineKind::Crease), 1.4F);
    EXPECT_FLOAT_EQ(settings.inner_width, 1.4F);
}

/// Seen from the front: a bar that goes behind a post.
scene::Model crossing() {
    return scene::combine(csg::Operation::Union,
                          {scene::box({-20, 5, -2}, {40, 2, 4}), scene::box({-3, -5, -12}, {6, 4, 24})});
}

npr::Picture from_the_front(const csg::Box& box, const char* halo, const char* taper) {
    npr::Picture p = picture_of(box, {120, 120});
    p.camera.rotation = {90, 0, 0};
    p.camera.projection = base::Projection::Orthographic;
    p.draw_as(*npr::find_style("lines"));
    p.parameters.read("halo", halo);
    p.parameters.read("taper", taper);
    return p;
}

/// Columns of the picture in which any pixel differs.
std::vector<int> columns_that_differ(const base::Image& a, const base::Image& b) {
    std::vector<int> columns;
    for (int x = 0; x < a.width; ++x) {
        for (int y = 0; y < a.height; ++y) {
            if (std::abs(a.pixel(x, y)[0] - b.pixel(x, y)[0]) > 2) {
                columns.push_back(x);
                break;
            }
        }
    }
    return columns;
}

TEST(LineTypes, HalosAreGapsBesideWhatIsNearer) {
    scene::Easel easel(crossing());
    const npr::Picture plain = from_the_front(easel.box(), "0", "0");
    const base::Image without = easel.paint(plain), with = easel.paint(from_the_front(easel.box(), "3", "0"));
    const double half = plain.camera.distance * std::tan(glm::radians(plain.camera.fov) / 2);
    const double post = 3 / half * 60;  // Pixels from the middle to its border.
    const std::vector<int> columns = columns_that_differ(with, without);
    ASSERT_GE(columns.size(), 4U);
    for (const int x : columns) {
        const double from_post = std::abs(x + 0.5 - 60) - post;
        EXPECT_GT(from_post, -2.5) << x;
        EXPECT_LT(from_post, 6) << x;
        for (int y = 0; y < with.height; ++y) {
            EXPECT_GE(with.pixel(x, y)[0] + 2, without.pixel(x, y)[0]) << "only lighter";
        }
    }
}

TEST(LineTypes, LinesAreThinnerTowardTheirEnds) {
    scene::Easel easel(crossing());
    const npr::Picture plain = from_the_front(easel.box(), "0", "0");
    npr::Picture tapered = plain;
    tapered.parameters.read("taper-ends", "0.9");
    const base::Image without = easel.paint(plain), with = easel.paint(tapered);
    const double half = plain.camera.distance * std::tan(glm::radians(plain.camera.fov) / 2);
    const double post = 3 / half * 60;  // Pixels from the middle to its border.
    // Darkness of the bar's two lines in a column.
    const auto ink = [&](const base::Image& image, int x) {
        int sum = 0;
        for (int y = 0; y < image.height; ++y) {
            sum += 255 - image.pixel(x, y)[0];
        }
        return sum;
    };
    const int border = static_cast<int>(60 + post);
    for (int x = border + 10; x < border + 14; ++x) {
        EXPECT_EQ(ink(with, x), ink(without, x)) << "not far from the post";
    }
    EXPECT_LT(ink(with, border + 3), 0.75 * ink(without, border + 3));
    EXPECT_LE(ink(with, border + 3), ink(with, border + 5));
    EXPECT_LE(ink(with, border + 5), ink(with, border + 7));
}

TEST(LineTypes, TaperedLinesAreThinnerFarAway) {
    scene::Easel easel(crossing());
    const auto ink_in = [](const base::Image& image, int x) {
        int sum = 0;
        for (int y = 0; y < image.height; ++y) {
            sum += 255 - image.pixel(x, y)[0];
        }
        return sum;
    };
    const base::Image without = easel.paint(from_the_front(easel.box(), "0", "0")),
                      with = easel.paint(from_the_front(easel.box(), "0", "0.8"));
    const auto left = [&](int x) { return static_cast<double>(ink_in(with, x)) / ink_in(without, x); };
    EXPECT_LT(left(20), 0.6) << "the bar";
    EXPECT_GT(left(60), left(20) + 0.1) << "the post";
}

/// The ink of all tiles, in layers 0 to 3.
std::vector<float> ink(const layers::HostStack& stack, const npr::Picture& picture, const base::View& view,
                       const LinedSettings& settings) {
    std::vector<glm::vec4> unused;
    const npr::CpuFrame frame{picture, view, stack, unused};
    const npr::CpuEdges edges = npr::find_edges(frame, settings);
    npr::shader::Frame rules(frame);
    npr::TileInk tile_ink(frame, edges, settings);
    const npr::Tiles tiles(stack);
    std::vector<float> all;
    for (int tile = 0; tile < tiles.count(); ++tile) {
        tile_ink.draw(tile, rules);
        const npr::TileBounds box = tiles.bounds(tile);
        for (int y = box.lo.y; y < box.hi.y; ++y) {
            for (int x = box.lo.x; x < box.hi.x; ++x) {
                for (int layer = 0; layer < 4; ++layer) {
                    all.push_back(tile_ink.ink(layer, {x, y}));
                }
            }
        }
    }
    return all;
}

TEST(LineTypes, PlainOnesDrawWhatTheMapAloneDoes) {
    const comparison::Subject subject(random_tree::make_tree(scene::widget()));
    const npr::Picture picture = picture_of(subject.geometry.box, {120, 110});
    const base::View view = subject.view(picture.camera, picture.size);
    layers::HostStack stack = goldfeather::peel_to_host(subject.scene, subject.geometry, view);
    stack.table = goldfeather::surface_table(subject.scene, subject.geometry);
    LinedSettings settings = settings_with(false);
    const std::vector<float> plain = ink(stack, picture, view, settings);
    settings.facts = true;
    const std::vector<float> typed = ink(stack, picture, view, settings);
    float most = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        most = std::max(most, plain[i]);
        ASSERT_NEAR(plain[i], typed[i], 1e-5) << i;
    }
    EXPECT_FLOAT_EQ(most, 0.9F);
    // And a table that says otherwise draws otherwise.
    settings.types.of(LineKind::Intersection, Visibility::Visible).strength = 0;
    EXPECT_NE(ink(stack, picture, view, settings), typed);
}

/// How white the picture is there, of the sample's pixels' centers about it.
double brightness(const base::Image& image, const glm::dvec2& at) {
    const glm::dvec2 low = glm::floor(at - 0.5), part = at - 0.5 - low;
    const auto red = [&](int x, int y) {
        return static_cast<double>(
            image.pixel(static_cast<int>(low.x) + x, image.height - 1 - static_cast<int>(low.y) - y)[0]);
    };
    return glm::mix(glm::mix(red(0, 0), red(1, 0), part.x), glm::mix(red(0, 1), red(1, 1), part.x), part.y);
}

TEST(LineTypes, DashesLieOnTheModel) {
    const glm::dvec3 size(40, 44, 16);
    scene::Easel easel(scene::box({7, -11, 3}, size));
    npr::Picture picture = picture_of(easel.box(), {320, 320});
    picture.draw_as(*npr::find_style("blueprint"));
    for (const auto& [name, value] :
         {std::pair{"dashes", "on"}, {"width", "2"}, {"hidden-width", "0.75"}, {"tone", "0"}, {"hidden", "1"}}) {
        picture.parameters.read(name, value);
    }
    const LinedSettings settings = [&] {
        LinedSettings s = settings_with(true);
        s.complete_lines(picture);
        return s;
    }();
    LineType type = npr::LineTypes(settings.types).of(LineKind::Crease, Visibility::Hidden);
    const double period = (type.dash + type.gap) * settings.line_unit;
    // A turntable by small steps; the lower edge at the back is hidden all the while.
    for (const int samples : {1, 16}) {
        for (int turn = 0; turn < 20; turn += samples == 1 ? 1 : 5) {
            picture.samples = samples;
            picture.camera.rotation = {60, 0, 15.0 + turn};
            const base::Image image = easel.paint(picture);
            const base::View view(picture.camera, picture.size, easel.box().lo, easel.box().hi);
            const auto at = [&](double x) {
                const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(x, -11 + size.y, 3, 1);
                return brightness(image, (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(picture.size));
            };
            double on = 0, off = 0;
            int count = 0;
            for (double middle = std::ceil(9 / period) * period; middle + period < 45; middle += period, ++count) {
                on += at(middle);
                off += at(middle + period / 2);
            }
            ASSERT_GT(count, 10);
            // The ground has 27; a line that crept would give both about the same.
            EXPECT_GT(on / count, 120) << fmt::format("turn {}, {} samples", turn, samples);
            EXPECT_GT((on - off) / count, 60) << fmt::format("turn {}, {} samples", turn, samples);
        }
    }
}

}  // namespace
